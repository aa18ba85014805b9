#include "navigation/bspline_time.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/navigator_properties.hpp"

namespace fulbito {

TEST_CASE("bspline-time keeps what every navigator promises", "[unit]") {
  test::checkNavigatorProperties("bspline-time");
}

}  // namespace fulbito
