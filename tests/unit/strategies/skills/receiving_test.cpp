#include "strategies/skills/receiving.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "navigation/followers/limiter.hpp"
#include "strategies/prediction/ball_prediction.hpp"
#include "strategies/skills/interception.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/draws.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/support/worlds.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

constexpr double kDt = 1.0 / 60;
constexpr int kTicks = 360;  // ticks per trial: 6 s
// [m] gap, [m/s], [s] limits of a ball under control
constexpr double kNear = 0.012, kSlow = 0.10, kHeld = 0.25;
constexpr double kOpen = 0.06;  // [m] least distance from the walls in the open

enum class Way { kIntercept, kReceive };

/// Results of one way of playing on many rolling balls.
struct Bench {
  int trials = 0, touched = 0, controlled = 0;
  double touch_time = 0.0, touch_speed = 0.0;  ///< means over the trials with a touch
  double control_time = 0.0;                   ///< mean over the trials with control
  double control_speed = 0.0;                  ///< [m/s] mean speed of the ball at that time
  /// part of `controlled` with the ball 6 cm or more from all walls
  int in_the_open = 0;
};

/// The gap [m] between the ball and the robot's nearer face; large if the ball is not in front of a face.
double faceGap(const RobotState& robot, const BallState& ball, const MatchInfo& info) {
  const Vec2 at = intoFrame(math::unit(robot.pose.heading), ball.position - robot.pose.position);
  if (std::abs(at.y) > info.robot.width / 2) return 1.0;
  return std::abs(at.x) - info.robot.length / 2 - info.ball.radius;
}

/// Drives at top speed straight to the earliest meeting, which it updates every tick.
Twist meet(const RobotState& robot, const BallState& ball, const MatchInfo& info, const RobotPace& pace) {
  BallPrediction prediction;
  prediction.predict(BallCourse(info.field, info.ball, info.physics), ball, 4.0);
  const auto meeting = intercept(prediction, pace, robot);
  const Vec2 to = (meeting ? meeting->ball : ball.position) - robot.pose.position;
  double error = math::wrapAngle(math::angleOf(to) - robot.pose.heading);
  const bool backward = std::abs(error) > math::kPi / 2;
  if (backward) error = math::wrapAngle(error + math::kPi);
  const math::SinCos sc = math::sinCos(error);
  return {(backward ? -pace.speed : pace.speed) * sc.cos * sc.cos, 10.0 * sc.sin};
}

void play(Way way, std::uint64_t seed, const MatchInfo& info, Bench& bench) {
  Rng rng(seed, test::kTestStream, 18);
  WorldConfig config{info.field, info.physics, {}, {}, {}};
  const Vec2 velocity = test::drawVector(rng, 0.3, 0.7);
  config.balls.push_back({info.ball, {rng.uniform(-0.4, 0.4), rng.uniform(-0.35, 0.35)}, velocity, velocity});
  const Vec2 place{rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)};
  if (distance(place, config.balls[0].position) < 0.15) return;
  ++bench.trials;
  config.robots.push_back({info.robot, {place, rng.uniform(-math::kPi, math::kPi)}, {}, 0.0});
  World world = test::makeWorld(config);
  const RobotPace pace(info.robot);
  bool touched = false;
  double held = 0.0, speed_before = 0.0;
  for (int tick = 0; tick < kTicks; ++tick) {
    const RobotState& robot = world.state().robots[0];
    const BallState& ball = world.state().balls[0];
    speed_before = norm(ball.velocity - robot.velocity);
    const Twist wanted = way == Way::kReceive ? receive(robot, ball, pace) : meet(robot, ball, info, pace);
    const Twist limited = limitTwist(info.robot, bodyTwist(robot), wanted, kDt);
    const WheelSpeeds wheels = saturate(info.robot, inverseKinematics(info.robot, limited));
    world.step({&wheels, 1});
    for (const ContactEvent& contact : world.contacts()) {
      if (touched || contact.a.kind != BodyKind::kRobot || contact.b.kind != BodyKind::kBall) continue;
      touched = true;
      ++bench.touched;
      bench.touch_time += tick * kDt;
      bench.touch_speed += speed_before;
    }
    const bool near = faceGap(world.state().robots[0], world.state().balls[0], info) < kNear &&
                      norm(world.state().balls[0].velocity - world.state().robots[0].velocity) < kSlow;
    held = near ? held + kDt : 0.0;
    if (held < kHeld) continue;
    const BallState& had = world.state().balls[0];
    ++bench.controlled;
    bench.control_time += tick * kDt;
    bench.control_speed += norm(had.velocity);
    if (wallClearance(info.field, had.position) >= kOpen) ++bench.in_the_open;
    return;
  }
}

Bench benchOf(Way way, std::uint64_t first, int trials) {
  const MatchInfo info = test::matchInfo();
  Bench bench;
  for (int i = 0; i < trials; ++i) play(way, first + static_cast<std::uint64_t>(i), info, bench);
  if (bench.touched > 0) bench.touch_time /= bench.touched, bench.touch_speed /= bench.touched;
  if (bench.controlled > 0) {
    bench.control_time /= bench.controlled;
    bench.control_speed /= bench.controlled;
  }
  return bench;
}

}  // namespace

TEST_CASE("the place of receiving is behind the ball, and beside its way from the front", "[unit]") {
  const BallState ball{{0.0, 0.0}, {0.4, 0.0}, {0.4, 0.0}};
  RobotState robot;
  robot.pose.position = {-0.3, 0.1};
  CHECK(receivingPlace(robot, ball).x == Approx(-0.055));
  CHECK(receivingPlace(robot, ball).y == Approx(0.0).margin(1e-12));
  robot.pose.position = {0.3, 0.1};
  CHECK(receivingPlace(robot, ball).y == Approx(0.10));
  robot.pose.position = {0.3, -0.1};
  CHECK(receivingPlace(robot, ball).y == Approx(-0.10));
}

TEST_CASE("a robot at its place drives with the ball", "[unit]") {
  const BallState ball{{0.0, 0.0}, {0.0, 0.4}, {0.0, 0.4}};
  RobotState robot;
  robot.pose = {{0.0, -0.055}, math::kPi / 2};
  const RobotPace pace;
  CHECK(receive(robot, ball, pace).linear == Approx(0.4));
  CHECK(receive(robot, ball, pace).angular == Approx(0.0).margin(1e-9));
  robot.pose.heading = -math::kPi / 2;  // the back may lead as well
  CHECK(receive(robot, ball, pace).linear == Approx(-0.4));
  robot.pose.position.y = -3.0;
  CHECK(std::abs(receive(robot, ball, pace).linear) <= pace.speed);
  const BallState resting{{0.0, 0.0}, {}, {}};
  robot.pose = {{-0.055, 0.0}, 0.0};
  CHECK(receive(robot, resting, pace).linear == Approx(0.0).margin(0.01));
}

// docs/skills.md, Receiving, has these figures. Print them with strategies_test "[receiving]" -s.
TEST_CASE("receiving takes a rolling ball gently in the open, the interception takes it sooner and hard",
          "[unit][receiving]") {
  constexpr int kTrials = 300;
  const Bench met = benchOf(Way::kIntercept, 1000, kTrials), received = benchOf(Way::kReceive, 1000, kTrials);
  CAPTURE(met.trials, met.touched, met.touch_time, met.touch_speed, met.controlled, met.control_time,
          met.control_speed, met.in_the_open);
  CAPTURE(received.touched, received.touch_time, received.touch_speed, received.controlled,
          received.control_time, received.control_speed, received.in_the_open);
  CHECK(received.trials == met.trials);
  CHECK(received.touch_speed < 0.3 * met.touch_speed);
  CHECK(received.control_speed < met.control_speed);
  CHECK(received.in_the_open > met.in_the_open);
  CHECK(received.touch_time > met.touch_time);  // the disadvantage
}

}  // namespace fulbito
