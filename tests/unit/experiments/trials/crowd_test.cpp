#include "experiments/trials/crowd.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("six robots reach goal after goal among each other", "[unit]") {
  CrowdConfig config;
  config.seconds = 10.0;
  const auto first = runCrowd(config, {}), again = runCrowd(config, {});
  REQUIRE(first);
  CHECK(first->arrivals > 20);
  CHECK(first->arrivals == again->arrivals);
  CHECK(first->contacts == again->contacts);
  CHECK(first->compute_us_mean == 0.0);  // without a clock there are no times
  config.navigator = "bezir";
  CHECK(runCrowd(config, {}).error().code == ErrorCode::kUsage);
}

}  // namespace fulbito
