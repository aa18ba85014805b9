#include "navigation/geometry/body_clearance.hpp"

#include "engine/core/math/random.hpp"
#include "engine/core/models/shapes.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/kinematic_trial.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {

TEST_CASE("body clearance to a disc agrees with that of the shapes at any heading", "[unit]") {
  const RobotModel robot;
  Rng rng(3, test::kTestStream);
  for (int i = 0; i < 200; ++i) {
    const Pose2 pose{{rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)}, rng.uniform(-3.0, 3.0)};
    const Vec2 centre{rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)};
    CHECK(discClearance(bodyShape(robot), pose.position, math::unit(pose.heading), centre, 0.03) ==
          Approx(clearance(bodyOf(robot, pose), centre, 0.03)).margin(1e-12));
  }
}

TEST_CASE("body clearance to the walls is that of its nearest corner", "[unit]") {
  const RobotModel robot;
  const FieldGeometry field;
  Rng rng(4, test::kTestStream);
  for (int i = 0; i < 500; ++i) {
    const Pose2 pose{{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)}, rng.uniform(-3.0, 3.0)};
    CHECK(wallClearance(bodyShape(robot), pose.position, math::unit(pose.heading), field) ==
          Approx(test::bodyWallClearance(robot, pose, field)).margin(1e-9));
  }
}

}  // namespace fulbito
