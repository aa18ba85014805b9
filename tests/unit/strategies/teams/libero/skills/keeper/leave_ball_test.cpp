#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/keeper/keeper_at.hpp"

namespace fulbito {

TEST_CASE("libero's keeper does not push a ball in that lies behind it in the mouth", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.745, -0.006};
    scene.robots[0] = {test::keeperAt({-0.712, 0.052}, side), Pose2{{-0.25, -0.45}, 0.0}};
    const Match match = test::playedFrom(test::mirrored(scene, side), 1.5);
    CHECK(match.referee().score[1] == 0);
  }
}

}  // namespace fulbito
