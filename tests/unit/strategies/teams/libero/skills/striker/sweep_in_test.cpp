#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero turns a ball in that runs along their end wall", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    for (const double y : {0.30, 0.34, 0.42}) {
      CAPTURE(side, y);
      CHECK(test::scoresAlone({0.7285, y}, {{0.68, y + 0.10}, -1.3}, side) < 3.0);
    }
  }
}

}  // namespace fulbito
