#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/keeper/keeper_at.hpp"

namespace fulbito {

TEST_CASE("libero's keeper that was pushed into the goal pushes the ball before it out at once", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.715, 0.02};
    scene.robots[0] = {test::keeperAt({-0.778, 0.02}, side), Pose2{{-0.25, 0.45}, 0.0}};
    scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.35, 0.2}, 0.0}};
    const Match match = test::playedFrom(test::mirrored(scene, side), 1.0);
    CHECK(match.world().balls[0].position.x > -0.6);
    CHECK(match.referee().score[1] == 0);
  }
}

}  // namespace fulbito
