#include <cmath>
#include <vector>

#include "fulbito/detail/math.hpp"
#include "fulbito/sensors.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr double kTick = 0.05;  // [s]

RobotModel cart() {
  RobotModel robot;
  robot.wheel_radius = 0.05;
  robot.axle_track = 0.30;
  return robot;
}

/// The state of a robot that rolls without slip.
RobotState rolling(const Pose2& pose, Twist twist) {
  return {pose, math::unit(pose.heading) * twist.linear, twist.angular, inverseKinematics(cart(), twist)};
}

WheelEncoders encoders(const EncoderModel& model, std::uint64_t index = 0) {
  return {model, cart(), Rng(1, kTestStream, index)};
}

/// Distances [m] that the left and the right encoder count on a straight path of `length` [m] in steps of 15
/// mm.
struct Counted {
  double left, right;
};
Counted straight(WheelEncoders& sensor, double length) {
  const Twist twist{0.3, 0.0};
  RobotState before = rolling({{1.0, -2.0}, 0.7}, twist);
  Counted sum{0.0, 0.0};
  const int ticks = static_cast<int>(length / (twist.linear * kTick) + 0.5);
  for (int i = 0; i < ticks; ++i) {
    RobotState after = before;
    after.pose.position += before.velocity * kTick;
    const EncoderCounts counts = sensor.read(before, after, kTick);
    sum.left += static_cast<double>(counts.left) * sensor.metresPerCount();
    sum.right += static_cast<double>(counts.right) * sensor.metresPerCount();
    before = after;
  }
  return sum;
}

}  // namespace

TEST_CASE("encoders count the way of the rims to a count", "[unit]") {
  WheelEncoders sensor = encoders({});
  CHECK(sensor.metresPerCount() == Approx(2 * math::kPi * 0.05 / 2000));
  const Counted sum = straight(sensor, 3.0);
  CHECK(sum.left == Approx(3.0).margin(sensor.metresPerCount()));
  CHECK(sum.right == Approx(3.0).margin(sensor.metresPerCount()));
}

TEST_CASE("encoders of a robot that turns in place count against each other", "[unit]") {
  WheelEncoders sensor = encoders({});
  const Twist spin{0.0, 1.0};
  RobotState before = rolling({{}, 3.0}, spin), after = before;
  after.pose.heading = math::wrapAngle(3.0 + 0.4);  // across the angle where headings wrap
  const EncoderCounts counts = sensor.read(before, after, kTick);
  const double way = 0.4 * 0.15;
  CHECK(static_cast<double>(counts.right) * sensor.metresPerCount() ==
        Approx(way).margin(sensor.metresPerCount()));
  CHECK(static_cast<double>(counts.left) * sensor.metresPerCount() ==
        Approx(-way).margin(sensor.metresPerCount()));
}

TEST_CASE("a wheel that spins counts though the robot stands", "[unit]") {
  WheelEncoders sensor = encoders({});
  RobotState state;
  state.wheels = {10.0, 0.0};
  const EncoderCounts counts = sensor.read(state, state, kTick);
  CHECK(static_cast<double>(counts.left) * sensor.metresPerCount() ==
        Approx(10.0 * 0.05 * kTick).margin(sensor.metresPerCount()));
  CHECK(counts.right == 0);
}

TEST_CASE("scale errors belong to each wheel", "[unit]") {
  EncoderModel model;
  model.left_scale = 1.02;
  model.right_scale = 0.99;
  WheelEncoders sensor = encoders(model);
  const Counted sum = straight(sensor, 5.1);
  CHECK(sum.left == Approx(5.1 * 1.02).margin(1e-3));
  CHECK(sum.right == Approx(5.1 * 0.99).margin(1e-3));
}

TEST_CASE("slip noise grows with the root of the way", "[unit]") {
  EncoderModel model;
  model.slip_noise = 0.01;
  double short_square = 0.0, long_square = 0.0;
  constexpr int kRuns = 400;
  for (int run = 0; run < kRuns; ++run) {
    WheelEncoders sensor = encoders(model, static_cast<std::uint64_t>(run));
    const double a = straight(sensor, 0.9).left - 0.9;
    const double b = straight(sensor, 3.6).right - 3.6;
    short_square += a * a;
    long_square += b * b;
  }
  // 0.01 sqrt(length); the standard error of a standard deviation over 400 runs is 3.5 %.
  CHECK(std::sqrt(short_square / kRuns) == Approx(0.01 * std::sqrt(0.9)).epsilon(0.12));
  CHECK(std::sqrt(long_square / kRuns) == Approx(0.01 * std::sqrt(3.6)).epsilon(0.12));
}

TEST_CASE("encoders of a robot at rest count nothing, whatever their noise", "[unit]") {
  EncoderModel model;
  model.slip_noise = 0.1;
  WheelEncoders sensor = encoders(model);
  for (int i = 0; i < 100; ++i) {
    const EncoderCounts counts = sensor.read({}, {}, kTick);
    CHECK(counts.left == 0);
    CHECK(counts.right == 0);
  }
}
