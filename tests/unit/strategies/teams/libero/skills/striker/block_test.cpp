#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero's striker meets one opponent that is about to bring the ball", "[unit]") {
  // The striker is in front of the ball, beside the ball's way to its goal.
  Placement scene;
  scene.ball = {-0.137, -0.268};
  scene.robots[0] = {Pose2{{-0.696, -0.018}, -1.58}, Pose2{{-0.331, -0.224}, -0.70}};
  scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.025, -0.290}, math::kPi}};
  test::checkHolds(scene, 1.5, "chaser");
}

TEST_CASE("libero's striker still races for a ball in its own corner", "[unit]") {
  Placement scene;
  scene.ball = {-0.722, 0.50};
  scene.robots[0] = {Pose2{{-0.70, 0.0}, 1.57}, Pose2{{-0.62, 0.30}, 1.9}};
  scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.45, 0.55}, math::kPi}};
  test::checkHolds(scene, 2.0, "chaser");
}

}  // namespace fulbito
