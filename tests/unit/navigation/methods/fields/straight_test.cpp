#include <memory>

#include "tests/support/allocation_counter.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/navigator_properties.hpp"

namespace fulbito {

TEST_CASE("the allocation counter sees an allocation", "[unit]") {
  const std::uint64_t before = test::allocationCount();
  const auto number = std::make_unique<volatile int>(1);
  CHECK(test::allocationCount() == before + 1);
}

TEST_CASE("the straight reference keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("straight");
}

TEST_CASE("the classic follower keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("straight:follower=classic");
}

}  // namespace fulbito
