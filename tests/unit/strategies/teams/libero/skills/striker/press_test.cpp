#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero holds against one who presses on its ball head-on", "[unit]") {
  Placement scene;
  scene.ball = {-0.007, 0.046};
  scene.robots[0][1] = Pose2{{-0.069, 0.050}, -0.02};
  scene.robots[1][0] = Pose2{{0.053, 0.050}, 3.12};
  for (const double side : {1.0, -1.0}) {
    const Placement start = test::mirrored(scene, side);
    Match match = test::matchFrom(test::matchOf("libero", "chaser", "vsss-3v3", 10.0), start);
    // The direction in which the ball leaves the two robots must be sideways or upfield.
    Vec2 moved;
    while (norm(moved) < 0.04 && match.seconds() < 2.0 && match.step()) {
      moved = match.world().balls[0].position - start.ball;
    }
    CHECK(norm(moved) >= 0.04);
    CHECK(moved.x > -0.03);
  }
}

}  // namespace fulbito
