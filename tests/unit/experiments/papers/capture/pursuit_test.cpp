#include "experiments/papers/capture/pursuit.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/papers/capture/fig18.hpp"
#include "experiments/papers/capture/random_captures.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/report.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;
constexpr SightingNoise kNoise{0.02, 0.5 * kDegree};

RobotModel paperRobot() { return loadRobot("choi-lee-2005")->robot; }

}  // namespace

TEST_CASE("wheels over the ground allow for the slip", "[unit]") {
  const RobotModel robot = paperRobot();
  const WheelSpeeds wheels = wheelsOverGround(robot, {0.3, 0.1});
  RobotState state;
  state.velocity = {0.3, 0.0};
  state.wheels = inverseKinematics(robot, {0.3, 0.1});
  for (int i = 0; i < 60; ++i) state = rolledForward(robot, state, wheels, 1.0 / 60);
  CHECK(state.angular_velocity == Approx(0.1));
  CHECK(norm(state.velocity) == Approx(0.3));
}

TEST_CASE("the tracker turns toward its reference and speeds up to it", "[unit]") {
  const MotionState reference{{{1.0, 0.5}, 0.2}, {0.3, 0.0}};
  CHECK(trackingTwist(reference, {{1.0, 0.0}, 0.0}).angular > 0.0);
  CHECK(trackingTwist(reference, {{0.5, 0.5}, 0.2}).linear > 0.3);
  CHECK(trackingTwist(reference, reference.pose).linear == Approx(0.3));
  CHECK(trackingTwist(reference, reference.pose).angular == Approx(0.0).margin(1e-15));
}

TEST_CASE("the capture of Fig. 18 succeeds in the world", "[unit]") {
  const auto run = pursue(fig18Setup(paperRobot(), 0.24, kNoise, 1));
  REQUIRE(run);
  REQUIRE(run->answer.plan);
  CHECK(run->time > 27.0);
  CHECK(run->time < 31.5);
  CHECK(run->gap > 0.15);
  CHECK(run->gap < 0.33);
  CHECK(run->speed == Approx(0.3).margin(0.01));
  CHECK(run->heading == Approx(40 * kDegree).margin(2 * kDegree));
  CHECK(std::abs(run->aside) < 0.05);
  CHECK(run->robot.size() == run->object.size());
}

TEST_CASE("the printed speed of Fig. 18 fixes turn, time and gap, and excludes the printed time", "[unit]") {
  CHECK(fig18Turn(0.546) / kDegree == Approx(84.22).margin(0.01));
  const auto printed = printedPlan();
  REQUIRE(printed);
  CHECK(printed->top_speed == Approx(0.546));
  CHECK(printed->motion.duration() == Approx(27.235).margin(0.01));  // from an independent computation
  CHECK(printed->gap == Approx(0.153).margin(0.001));
  // A smaller turn gives a lower speed, takes longer and ends farther behind.
  double time = printed->motion.duration(), gap = printed->gap;
  for (const double speed : {0.535, 0.52, 0.505}) {
    const auto plan = fig18Plan(fig18Turn(speed));
    REQUIRE(plan);
    CHECK(plan->top_speed == Approx(speed));
    CHECK(plan->motion.duration() > time + 1.0);
    CHECK(plan->gap > gap + 0.05);
    time = plan->motion.duration(), gap = plan->gap;
  }
}

TEST_CASE("other errors of the sightings change the time of Fig. 18 by seconds, the gap by millimetres",
          "[unit]") {
  const auto runs = captureAgain(fig18Setup(paperRobot(), 0.26, kNoise, 4), 6, 1, {});
  REQUIRE(runs);
  REQUIRE(runs->size() == 6);
  std::vector<double> times, gaps;
  for (const PursuitResult& run : *runs) {
    REQUIRE(run.answer.plan);
    times.push_back(run.time), gaps.push_back(run.gap);
  }
  std::sort(times.begin(), times.end());
  std::sort(gaps.begin(), gaps.end());
  CHECK(times.back() - times.front() > 0.5);
  CHECK(gaps.back() - gaps.front() < 0.03);
  // The first run is the capture itself.
  CHECK(runs->front().time == pursue(fig18Setup(paperRobot(), 0.26, kNoise, 4))->time);
}

TEST_CASE("wheels that turn as planned follow the plan without slip and miss with it", "[unit]") {
  PursuitSetup setup = fig18Setup(paperRobot(), 0.24, {}, 1);
  setup.drive = PursuitDrive::kOpen;
  const auto slipping = pursue(setup);
  setup.robot.curve_widening = setup.robot.curve_widening_rise = 0.0;
  const auto ideal = pursue(setup);
  REQUIRE(slipping);
  REQUIRE(ideal);
  CHECK(ideal->worst_off < 0.02);
  CHECK(std::abs(ideal->gap - 0.24) < 0.01);
  CHECK(ideal->largest_rim <= 0.588);  // the paper's limit
  CHECK(std::abs(slipping->aside) > 1.0);
}

TEST_CASE("random tasks of one seed and index are the same, and captures do not depend on the jobs",
          "[unit]") {
  const RobotModel robot = paperRobot();
  const auto one = captureAtRandom(robot, 0.24, kNoise, 5, 3, 1, {});
  const auto two = captureAtRandom(robot, 0.24, kNoise, 5, 3, 2, {});
  REQUIRE(one);
  REQUIRE(two);
  REQUIRE(one->captures.size() == 3);
  REQUIRE(two->captures.size() == 3);
  CHECK(one->refused == two->refused);
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(one->captures[i].index == two->captures[i].index);
    CHECK(one->captures[i].gap_error == two->captures[i].gap_error);
    CHECK(one->captures[i].heading_error == two->captures[i].heading_error);
    CHECK(one->captures[i].caught());
    CHECK_FALSE(one->captures[i].touched);
  }
}

TEST_CASE("a capture counts only within all tolerances", "[unit]") {
  RandomCapture capture;
  CHECK(capture.caught());
  const auto missed = [&](double RandomCapture::* member, double value) {
    RandomCapture other = capture;
    other.*member = value;
    return !other.caught();
  };
  CHECK(missed(&RandomCapture::gap_error, -0.1));
  CHECK(missed(&RandomCapture::aside, 0.06));
  CHECK(missed(&RandomCapture::speed_error, -0.011));
  CHECK(missed(&RandomCapture::heading_error, 2.1 * kDegree));
  capture.touched = true;
  CHECK_FALSE(capture.caught());
}

TEST_CASE("random captures stop when they are told to", "[unit]") {
  const auto stopped =
      captureAtRandom(paperRobot(), 0.24, kNoise, 5, 3, 1, [](std::size_t, std::size_t) { return false; });
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::kInterrupted);
}

}  // namespace fulbito::capture
