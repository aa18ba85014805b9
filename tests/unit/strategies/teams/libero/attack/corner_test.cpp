#include "strategies/teams/libero/attack/corner.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "fulbito/match.hpp"
#include "fulbito/strategy.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

using namespace libero;

constexpr double kUp = 1.0, kDown = -1.0;  // side of the field on which a scene is played

Vec2 onSide(Vec2 v, double side) { return {v.x, side * v.y}; }

RobotState robotAt(Vec2 place, double heading, double side) {
  RobotState robot;
  robot.pose = {onSide(place, side), side * heading};
  return robot;
}

/// A picture with one own robot, one opponent and a resting ball.
struct Scene {
  Scene(Vec2 ball, Vec2 own, Vec2 opponent, double side) : self(robotAt(own, 2.0, side)) {
    seen.ball.position = onSide(ball, side);
    seen.own[0] = {true, self};
    seen.opponents[0] = {true, robotAt(opponent, 3.0, side)};
    forecast.take(seen.ball, {});
  }

  Vec2 rel() const { return seen.ball.position - self.pose.position; }
  Aim aim() const { return aimAt(pitch, seen.ball.position, pitch.theirGoal()); }
  Picture picture() const { return {seen, pitch, settings, forecast}; }
  bool races() const { return racesAlongWall(picture(), rel(), aim()); }
  bool pushes() const { return squeezes(picture(), rel(), aim()); }

  Pitch pitch{test::matchInfo()};
  Settings settings;
  Observation seen;
  BallForecast forecast;
  RobotState self;
};

constexpr Vec2 kAtCut{-0.725, 0.56};      // at the end wall, where the corner triangle begins
constexpr Vec2 kAtEndWall{-0.728, 0.45};  // along the end wall, toward the own goal

}  // namespace

TEST_CASE("libero races for a ball in its corner only from our goal's side, with an opponent near",
          "[unit]") {
  for (const double side : {kUp, kDown}) {
    CHECK(Scene(kAtCut, {-0.55, 0.35}, {-0.50, 0.60}, side).races());
    CHECK_FALSE(Scene(kAtCut, {-0.55, 0.35}, {-0.10, 0.50}, side).races());  // there is time enough
    // it would push the ball toward its own goal
    CHECK_FALSE(Scene(kAtCut, {-0.66, 0.62}, {-0.50, 0.60}, side).races());
    CHECK_FALSE(Scene({-0.50, 0.30}, {-0.60, 0.20}, {-0.40, 0.40}, side).races());  // there is no wall
  }
}

TEST_CASE("libero drives straight at a ball it races for", "[unit]") {
  for (const double side : {kUp, kDown}) {
    Scene scene(kAtCut, {-0.55, 0.35}, {-0.50, 0.60}, side);
    scene.self.pose.heading = math::angleOf(scene.rel());
    const Twist twist = raceAlongWall(scene.picture(), scene.self, scene.aim());
    CHECK(twist.linear > 0.95 * scene.pitch.speed);
    CHECK(std::abs(twist.angular) < 1.5);
  }
}

TEST_CASE("libero squeezes a ball between the ball's own direction and the wall's", "[unit]") {
  const Vec2 off{0.02, -0.06};  // [m] position of the robot relative to the ball
  for (const double side : {kUp, kDown}) {
    const Scene scene(kAtEndWall, kAtEndWall + off, kAtEndWall + Vec2{0.06, 0.03}, side);
    CHECK(scene.pushes());
    const auto turn = [&](double heading) {
      const RobotState robot = robotAt(kAtEndWall + off, heading, side);
      const Twist twist = squeeze(scene.picture(), robot, scene.rel(), scene.aim());
      CHECK(twist.linear > 0.8 * scene.pitch.speed);
      return side * twist.angular;
    };
    CHECK(turn(math::angleOf(-off)) < 0.0);  // a push straight at the ball would only hold it
    // parallel to the wall, the ball would slip through behind the robot
    CHECK(turn(math::kPi / 2) > 0.0);
    const Scene early(kAtEndWall, kAtEndWall + off, kAtEndWall + Vec2{0.25, 0.05}, side);
    CHECK_FALSE(early.pushes());
    const Scene far(kAtEndWall, kAtEndWall + 2.5 * off, kAtEndWall + Vec2{0.06, 0.03}, side);
    CHECK_FALSE(far.pushes());
  }
}

namespace {

/// Time [s] until libero has moved the ball 0.25 m up the side wall out of its corner, against a robot that
/// drives straight at it; 5 if it does not.
double secondsOut(Vec2 ball, Pose2 own, Pose2 opponent, double side) {
  MatchConfig config;
  config.teams = {*parseTeam("libero"), *parseTeam("chaser")};
  config.rules = *loadRules("vsss-3v3");
  config.rules.stuck.seconds = config.rules.stuck.area_seconds = 20.0;
  config.field = *loadField("vsss-3v3");
  config.robot = *loadRobot("vsss");
  config.physics = *loadPhysics("standard");
  Placement start;
  start.ball = onSide(ball, side);
  start.robots[0][0] = Pose2{onSide(own.position, side), side * own.heading};
  start.robots[1][1] = Pose2{onSide(opponent.position, side), side * opponent.heading};
  config.start = start;
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->seconds() < 5.0 && match->step()) {
    if (match->world().balls[0].position.x > ball.x + 0.25) break;
  }
  return match->seconds();
}

}  // namespace

TEST_CASE("libero brings a ball out of its corner though another comes at the same time", "[unit]") {
  struct Start {
    Vec2 ball;
    Pose2 own, opponent;
  };
  int scenes = 0, out = 0;
  for (const Start& start : {Start{kAtCut, {{-0.35, 0.30}, 2.5}, {{-0.12, 0.52}, 3.0}},
                             Start{{-0.695, 0.595}, {{-0.40, 0.25}, 2.3}, {{-0.10, 0.50}, 3.0}}}) {
    for (const double later : {-0.03, -0.02, -0.01, 0.0, 0.01, 0.02, 0.03}) {
      for (const double side : {kUp, kDown}) {
        Pose2 own = start.own;
        own.position.x += later;
        ++scenes;
        out += secondsOut(start.ball, own, start.opponent, side) < 5.0 ? 1 : 0;
      }
    }
  }
  CAPTURE(out, scenes);
  CHECK(out >= 20);  // of 28
}

}  // namespace fulbito
