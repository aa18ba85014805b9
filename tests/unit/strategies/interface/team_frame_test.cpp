#include "strategies/interface/team_frame.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {

TEST_CASE("the team frame is a rotation by 180 degrees and its own inverse", "[unit]") {
  Rng rng(1, test::kTestStream);
  for (int i = 0; i < 1000; ++i) {
    RobotState robot;
    robot.pose = {{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)}, rng.uniform(-math::kPi, math::kPi)};
    robot.velocity = {rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)};
    robot.angular_velocity = rng.uniform(-20.0, 20.0);
    const RobotState seen = inTeamFrame(Side::kRight, robot);
    CHECK(seen.pose.position == -robot.pose.position);
    CHECK(seen.velocity == -robot.velocity);
    CHECK(seen.angular_velocity == robot.angular_velocity);  // a reflection would change its sign
    const Vec2 ahead = math::unit(seen.pose.heading) + math::unit(robot.pose.heading);
    CHECK(norm(ahead) < 1e-12);
    const RobotState back = inTeamFrame(Side::kRight, seen);
    CHECK(back.pose.position == robot.pose.position);
    CHECK(std::abs(math::wrapAngle(back.pose.heading - robot.pose.heading)) < 1e-15 * 8);
    CHECK(inTeamFrame(Side::kLeft, robot).pose.heading == robot.pose.heading);
  }
}

}  // namespace fulbito
