#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero frees itself from a post of its goal", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    CHECK(test::scoresAlone({-0.626, 0.189}, {{-0.728, 0.157}, 1.40}, side) < 7.0);
    CHECK(test::scoresAlone({-0.638, 0.189}, {{-0.721, 0.163}, -1.55}, side) < 7.0);
  }
}

}  // namespace fulbito
