#include "navigation/followers/yield_speed.hpp"

#include "engine/core/math/random.hpp"
#include "fulbito/navigation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

/// The yield speed of a robot at the origin that drives along x at its top speed of 1 m/s.
double yieldTo(std::vector<DiscObstacle> obstacles, double speed = 1.0, double horizon = 1.0) {
  const FieldGeometry field;
  const RobotModel robot = test::paperRobot(1.0);
  NavigationScene scene;
  scene.field = &field;
  scene.robot = &robot;
  scene.self.velocity = {speed, 0.0};
  scene.obstacles = obstacles;
  return yieldSpeed(scene, std::vector<Vec2>{{0.0, 0.0}, {2.0, 0.0}}, horizon);
}

}  // namespace

TEST_CASE("nothing is yielded to obstacles at rest or out of the way", "[unit]") {
  CHECK(yieldTo({}) > 1e9);
  CHECK(yieldTo({{{0.5, 0.0}, 0.04, {0.0, 0.0}}}) > 1e9);
  CHECK(yieldTo({{{0.5, 0.4}, 0.04, {0.0, 0.5}}}) > 1e9);
  CHECK(yieldTo({{{0.5, 0.4}, 0.04, {-0.2, 0.0}}}) > 1e9);
}

TEST_CASE("an obstacle that crosses when the robot would be there is let pass", "[unit]") {
  // Both would be at (0.5, 0) after half a second.
  const DiscObstacle crossing{{0.5, -0.4}, 0.04, {0.0, 0.8}};
  const double speed = yieldTo({crossing});
  CHECK(speed < 1.0);
  CHECK(speed > 0.0);
  // A shorter horizon does not include the meeting.
  CHECK(yieldTo({crossing}, 1.0, 0.3) > 1e9);
  // The robot does not wait for an obstacle that has passed by then.
  CHECK(yieldTo({{{0.9, -0.1}, 0.04, {0.0, 0.8}}}) > 1e9);
}

TEST_CASE("where every speed meets an obstacle the one that meets it last is taken", "[unit]") {
  CHECK(yieldTo({{{0.4, 0.0}, 0.04, {-1.0, 0.0}}}, 0.0) == 0.0);
}

TEST_CASE("yielding keeps the path methods out of most crossing obstacles", "[unit]") {
  const auto safe = [](const char* name) {
    auto pilot = makePilot(*parseNavigator(name));
    int count = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      Rng rng(seed, test::kTestStream, 9);
      const double side = rng.below(2) == 0 ? 1.0 : -1.0;
      const std::vector<DiscObstacle> obstacles{{{rng.uniform(-0.4, 0.5), side * rng.uniform(0.3, 0.6)},
                                                 0.0375,
                                                 {rng.uniform(-0.2, 0.2), -side * rng.uniform(0.3, 1.0)}}};
      NavigationGoal goal;
      goal.position = {0.63, 0.0};
      const auto result =
          test::kinematicTrial(**pilot, test::paperRobot(1.0), {}, {{-0.63, 0.0}, 0.0}, goal, obstacles);
      if (result.reached && !result.touched) ++count;
    }
    return count;
  };
  const int without = safe("bezier:yield=0"), with = safe("bezier");
  INFO("safe of 60: " << without << " without, " << with << " with");
  CHECK(with >= 58);
  CHECK(without < with);
}

}  // namespace fulbito
