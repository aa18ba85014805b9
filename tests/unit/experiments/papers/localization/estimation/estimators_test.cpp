#include <cmath>
#include <vector>

#include "experiments/papers/localization/estimation/ekf_estimator.hpp"
#include "experiments/papers/localization/estimation/threshold_estimator.hpp"
#include "experiments/papers/localization/estimation/wall_ahead.hpp"
#include "experiments/papers/localization/route_driver.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::localization;
using namespace fulbito::test;

namespace {

constexpr double kTick = 0.05;
constexpr double kEchoSpeed = 172.0;

Knowledge knowledge() {
  Knowledge known;
  known.room = {4.0, 3.0};
  known.body = {0.44, 0.40};
  known.axle_track = 0.32;
  known.pose = {{0.5, 0.5}, 0.0};
  known.echo_speed = kEchoSpeed;
  return known;
}

EchoTimes echoesAt(const Knowledge& known, const Pose2& pose, double noise, Rng& random) {
  EchoTimes times;
  for (const Beam beam : kBeams) {
    const WallAhead wall = wallAhead(known.room, known.body, pose, beam);
    if (std::abs(wall.incidence) <= known.cone)
      times[indexOf(beam)] = (wall.distance + random.normal(0.0, noise)) / kEchoSpeed;
  }
  return times;
}

/// A robot that drives round the room, with the sensor errors that the filter expects.
class Drive {
 public:
  Drive(const Knowledge& known, const EkfSettings& settings, std::uint64_t index)
      : known_(known),
        settings_(settings),
        random_(9, kTestStream, index),
        truth_(known.pose),
        driver_({{0.5, 0.5}, {3.5, 0.5}, {3.5, 2.5}, {0.5, 2.5}, {0.5, 0.5}}, {}) {
    truth_.heading += random_.normal(0.0, settings.start_heading);
    truth_.position.x += random_.normal(0.0, std::sqrt(settings.start[0]));
    truth_.position.y += random_.normal(0.0, std::sqrt(settings.start[4]));
    bias_ = known.gyro_bias + random_.normal(0.0, settings.start_bias);
    gyro_scale_ = random_.normal(1.0, settings.gyro_scale);
    const double left = random_.normal(1.0, settings.encoder_scale);
    const double right = random_.normal(1.0, settings.encoder_scale);
    left_ = left, right_ = right;
  }

  /// One tick along the route by the true pose. @return false at the end of the route
  bool step(PoseEstimator& estimator, int tick) {
    const Twist twist = driver_.drive(truth_);
    if (driver_.finished()) return false;
    const double way = twist.linear * kTick, turned = twist.angular * kTick;
    truth_ = movedBy(truth_, way, turned);
    bias_ += random_.normal(0.0, settings_.gyro_drift * std::sqrt(kTick));
    InnerMotion motion;
    motion.dt = kTick;
    motion.turn_rate = gyro_scale_ * twist.angular + bias_ + random_.normal(0.0, settings_.gyro_noise);
    const double half = turned * known_.axle_track / 2;
    motion.distance = (wheel(way - half, left_) + wheel(way + half, right_)) / 2;
    estimator.advance(motion);
    if (tick % 2 == 0) estimator.observe(echoesAt(known_, truth_, known_.range_sigma, random_));
    return true;
  }
  const Pose2& truth() const { return truth_; }

 private:
  double wheel(double travel, double scale) {
    return travel / scale + random_.normal(0.0, settings_.slip * std::sqrt(std::abs(travel)));
  }

  Knowledge known_;
  EkfSettings settings_;
  Rng random_;
  Pose2 truth_;
  RouteDriver driver_;
  double bias_ = 0.0, gyro_scale_ = 1.0, left_ = 1.0, right_ = 1.0;
};

EkfSettings filterSettings() {
  EkfSettings settings;
  settings.start = {9e-6, 0, 0, 0, 9e-6, 0, 0, 0, 1e-4};
  return settings;
}

/// Largest distance of an estimate from the truth over a drive [m].
double worstError(PoseEstimator& estimator, std::uint64_t index) {
  Drive drive(knowledge(), filterSettings(), index);
  double worst = 0.0;
  for (int tick = 0; drive.step(estimator, tick); ++tick)
    worst = std::max(worst, distance(estimator.pose().position, drive.truth().position));
  return worst;
}

}  // namespace

TEST_CASE("dead reckoning follows the exact arc of encoders and gyro", "[unit]") {
  Knowledge known = knowledge();
  known.gyro_bias = 0.02;
  DeadReckoning reckoning(known);
  constexpr int kTicks = 400;
  for (int i = 0; i < kTicks; ++i) reckoning.advance({0.015, 0.02 + math::kPi / 2 / (kTicks * kTick), kTick});
  const double radius = 6.0 / (math::kPi / 2);  // a quarter circle of 6 m
  CHECK(reckoning.pose().position.x == Approx(0.5 + radius).margin(1e-4));
  CHECK(reckoning.pose().position.y == Approx(0.5 + radius).margin(1e-4));
  CHECK(reckoning.pose().heading == Approx(math::kPi / 2));
}

// With independent runs, the mean of n values of 3 degrees of freedom has the deviation sqrt(6 / n).
TEST_CASE("the filter's covariance is that of its errors", "[unit]") {
  constexpr int kRuns = 150;
  for (const int moment : {100, 400, 700}) {
    double sum = 0.0;
    for (int run = 0; run < kRuns; ++run) {
      EkfEstimator filter(knowledge(), filterSettings());
      Drive drive(knowledge(), filterSettings(), static_cast<std::uint64_t>(run));
      for (int tick = 0; tick < moment; ++tick) REQUIRE(drive.step(filter, tick));
      sum += filter.squaredError(drive.truth()) / kRuns;
    }
    CHECK(sum == Approx(3.0).margin(4 * std::sqrt(6.0 / kRuns)));
  }
}

TEST_CASE("the filter finds the constant again that it was told wrong", "[unit]") {
  Knowledge wrong = knowledge();
  wrong.echo_speed = 1.01 * kEchoSpeed;
  EkfSettings settings = filterSettings();
  settings.start[8] = 9.0;
  EkfEstimator filter(wrong, settings);
  Drive drive(knowledge(), filterSettings(), 1);
  for (int tick = 0; drive.step(filter, tick);) ++tick;
  CHECK(filter.echoSpeed() == Approx(kEchoSpeed).epsilon(0.002));
}

TEST_CASE("the filter refuses an echo of something else", "[unit]") {
  EkfEstimator filter(knowledge(), filterSettings());
  const Pose2 before = filter.pose();
  EchoTimes times;
  times[indexOf(Beam::kFront)] = 1.0 / kEchoSpeed;  // the wall is at 3.28 m
  filter.observe(times);
  CHECK(filter.pose().position == before.position);
  CHECK(filter.pose().heading == before.heading);
}

TEST_CASE("corrections keep the pose where dead reckoning loses it", "[unit]") {
  int lost = 0;
  for (std::uint64_t run = 0; run < 20; ++run) {
    DeadReckoning reckoning(knowledge());
    ThresholdEstimator threshold(knowledge(), {});
    EkfEstimator filter(knowledge(), filterSettings());
    lost += worstError(reckoning, run) > 0.05 ? 1 : 0;
    CHECK(worstError(threshold, run) < 0.045);
    CHECK(worstError(filter, run) < 0.03);
  }
  CHECK(lost >= 15);
}

TEST_CASE("the threshold scheme corrects half of a difference that three echoes show", "[unit]") {
  const Knowledge known = knowledge();
  ThresholdEstimator estimator(known, {});
  Rng random(10, kTestStream);
  Pose2 truth = known.pose;
  truth.position.y += 0.03;
  const EchoTimes times = echoesAt(known, truth, 0.0, random);
  // Two echoes fill the gate; then three must differ. Left and right sensors see the same difference. The
  // left one comes last and no longer differs by 20 mm, since the right one has corrected half of it.
  for (int i = 0; i < 4; ++i) {
    estimator.observe(times);
    CHECK(estimator.pose().position.y == known.pose.position.y);
  }
  estimator.observe(times);
  CHECK(estimator.pose().position.y == Approx(known.pose.position.y + 0.015));
  for (int i = 0; i < 20; ++i) estimator.observe(times);
  CHECK(estimator.pose().position.y ==
        Approx(known.pose.position.y + 0.015));  // 15 mm are below the threshold
  CHECK(estimator.pose().position.x == known.pose.position.x);
}

TEST_CASE("the threshold scheme turns the heading by the slope along a wall", "[unit]") {
  const Knowledge known = knowledge();
  ThresholdSettings settings;
  ThresholdEstimator estimator(known, settings);
  Rng random(11, kTestStream);
  Pose2 truth = known.pose;
  truth.heading = 0.02;
  for (int i = 0; estimator.pose().heading == 0.0 && i < 100; ++i) {
    estimator.advance({0.03, 0.0, 0.1});
    truth = movedBy(truth, 0.03, 0.0);
    estimator.observe(echoesAt(known, truth, 0.0, random));
  }
  CHECK(estimator.pose().heading == Approx(settings.heading_gain * 0.02).epsilon(0.03));
}

TEST_CASE("the threshold scheme turns the heading while the robot steers, as it does after each correction",
          "[unit]") {
  const Knowledge known = knowledge();
  ThresholdEstimator estimator(known, {});
  Rng random(13, kTestStream);
  Pose2 truth = known.pose;
  truth.heading = 0.03;
  for (int i = 0; i < 90; ++i) {
    const double rate = i / 5 % 2 == 0 ? 0.2 : -0.2;  // [rad/s] above 0.1, below the rate of a turn in place
    estimator.advance({0.03, rate, 0.1});
    truth = movedBy(truth, 0.03, rate * 0.1);
    estimator.observe(echoesAt(known, truth, 0.0, random));
  }
  CHECK(std::abs(math::wrapAngle(estimator.pose().heading - truth.heading)) < 0.005);
}

TEST_CASE("the threshold scheme ignores jumps, far echoes and echoes in turns", "[unit]") {
  const Knowledge known = knowledge();
  Rng random(12, kTestStream);
  Pose2 far = known.pose, off = known.pose;
  far.position.y += 0.2;  // beyond 3 sigma of a pose known within the threshold
  off.position.y += 0.04;
  ThresholdEstimator still(known, {}), turning(known, {});
  for (int i = 0; i < 10; ++i) {
    still.observe(echoesAt(known, far, 0.0, random));
    turning.advance({0.0, i % 2 == 0 ? 0.5 : -0.5, kTick});
    turning.observe(echoesAt(known, off, 0.0, random));
  }
  CHECK(still.pose().position == known.pose.position);
  CHECK(turning.pose().position == known.pose.position);
}
