#include "strategies/prediction/wheel_track.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

constexpr double kDt = 1.0 / 60.0;
constexpr double kNoise = 0.002;         // [m]
constexpr double kHeadingNoise = 0.053;  // [rad]

RobotState blurred(Rng& rng, RobotState robot) {
  robot.pose.position += Vec2{rng.normal(), rng.normal()} * kNoise;
  robot.pose.heading = math::wrapAngle(robot.pose.heading + rng.normal() * kHeadingNoise);
  return robot;
}

}  // namespace

TEST_CASE("wheels and noisy poses together give an own robot's state", "[unit]") {
  const RobotModel model = test::matchInfo().robot;
  for (const std::uint64_t seed : {1, 2, 3}) {
    Rng rng(seed, test::kTestStream);
    WheelTrack track(model, kNoise, kHeadingNoise);
    RobotState truth;
    double heading_square = 0.0, position_square = 0.0;
    constexpr int kTicks = 600;
    WheelSpeeds command;
    for (int i = 0; i < kTicks; ++i) {
      if (i % 20 == 0) command = {rng.uniform(-25.0, 25.0), rng.uniform(-25.0, 25.0)};
      truth = rolledForward(model, truth, command, kDt);
      const RobotState state = track.update(blurred(rng, truth), kDt);
      heading_square += std::pow(math::wrapAngle(state.pose.heading - truth.pose.heading), 2);
      position_square += squaredNorm(state.pose.position - truth.pose.position) / 2;
    }
    CHECK(std::sqrt(heading_square / kTicks) < 0.4 * kHeadingNoise);
    CHECK(std::sqrt(position_square / kTicks) < 0.6 * kNoise);
  }
}

TEST_CASE("a robot that is shoved is found at its new place at once", "[unit]") {
  Rng rng(1, test::kTestStream);
  WheelTrack track(test::matchInfo().robot, kNoise, kHeadingNoise);
  RobotState robot;
  for (int i = 0; i < 30; ++i) track.update(blurred(rng, robot), kDt);
  robot.pose = {{0.03, 0.02}, 0.8};
  const RobotState state = track.update(blurred(rng, robot), kDt);
  CHECK(distance(state.pose.position, robot.pose.position) < 5.0 * kNoise);
  CHECK(std::abs(state.pose.heading - robot.pose.heading) < 5.0 * kHeadingNoise);
}

TEST_CASE("exact headings are taken as they are", "[unit]") {
  WheelTrack track(test::matchInfo().robot, kNoise, 0.0);
  RobotState robot;
  track.update(robot, kDt);
  robot.pose = {{0.001, 0.0}, 0.3};  // another place: the same picture again would not count
  CHECK(track.update(robot, kDt).pose.heading == Approx(0.3));
}

}  // namespace fulbito
