#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/keeper/keeper_at.hpp"

namespace fulbito {

TEST_CASE("libero's keeper stays at its post before a ball that is brought fast along the end wall",
          "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.728, -0.45};
    scene.ball_velocity = {0.0, 2.0};
    scene.robots[0] = {test::keeperAt({-0.708, -0.15}, side), Pose2{{-0.2, 0.3}, 0.0}};
    const Match match = test::playedFrom(test::mirrored(scene, side), 0.10);
    CHECK(side * match.world().robots[0].pose.position.y > -0.19);
    CHECK(test::playedFrom(test::mirrored(scene, side), 2.0).referee().score[1] == 0);
  }
}

TEST_CASE("libero's keeper holds a ball out that is pressed past the post beside it", "[unit]") {
  Placement scene;
  scene.ball = {-0.728, -0.205};
  scene.robots[0] = {Pose2{{-0.699, -0.149}, -1.70}, Pose2{{-0.25, -0.45}, 0.0}};
  scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.702, -0.259}, 1.91}};
  test::checkHolds(scene, 1.0, "chaser");
}

}  // namespace fulbito
