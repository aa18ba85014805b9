#include "tests/support/kinematic_trial.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"

namespace fulbito {
namespace {

constexpr double kStep = 1e-3;  // [s]

}  // namespace

TEST_CASE("the kinematic robot follows a bend within its grip", "[unit]") {
  const RobotModel robot = test::paperRobot(2.6);
  test::KinematicRobot body;
  for (int i = 0; i < 2000; ++i) body.step(robot, inverseKinematics(robot, {1.0, 4.0}), kStep);
  CHECK(norm(body.state.velocity) == Approx(1.0).epsilon(1e-3));
  CHECK(std::abs(cross(math::unit(body.state.pose.heading), body.state.velocity)) < 1e-2);
}

TEST_CASE("a turn beyond the grip makes the kinematic robot slide, not faster than its wheels", "[unit]") {
  const RobotModel robot = test::paperRobot(2.6);
  test::KinematicRobot body;
  double fastest = 0.0, slip = 0.0;
  for (int i = 0; i < 4000; ++i) {
    body.step(robot, inverseKinematics(robot, {1.5, 12.0}), kStep);  // needs 18 m/s^2, but the grip is 6
    fastest = std::max(fastest, norm(body.state.velocity));
    slip = std::max(slip, std::abs(cross(math::unit(body.state.pose.heading), body.state.velocity)));
  }
  CHECK(slip > 0.5);
  CHECK(fastest <= 1.5 + 1e-12);
}

TEST_CASE("sideways motion of the kinematic robot dies by the lateral grip", "[unit]") {
  const RobotModel robot = test::paperRobot(1.0);
  test::KinematicRobot body;
  body.state.velocity = {0.0, 0.3};
  for (int i = 0; i < 25; ++i) body.step(robot, {}, kStep);
  CHECK(body.state.velocity.y == Approx(0.3 - 6.0 * 0.025));
  for (int i = 0; i < 30; ++i) body.step(robot, {}, kStep);
  CHECK(body.state.velocity == Vec2{});
}

}  // namespace fulbito
