#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// Time [s] until a single robot has a resting ball in the opponents' goal; negative for an own goal; 0 if
/// there is no goal.
double secondsToScore(Vec2 robot, Vec2 ball) {
  Placement scene;
  scene.ball = ball;
  scene.robots[0][1] = Pose2{robot, 1.0};
  Match match = test::matchFrom(test::matchOf("libero", "idle", "vsss-3v3", 10.0), scene);
  while (match.step()) {
    const PerTeam<int> score = match.referee().score;
    if (score[0] > 0) return match.seconds();
    if (score[1] > 0) return -match.seconds();
  }
  return 0.0;
}

}  // namespace

TEST_CASE("a lone libero brings a resting ball into the right goal", "[unit]") {
  int scored = 0;
  for (const Vec2 ball :
       {Vec2{0.4, 0.3}, Vec2{0.0, -0.45}, Vec2{-0.45, 0.2}, Vec2{-0.55, -0.4}, Vec2{0.55, -0.4}}) {
    const double seconds = secondsToScore({0.1, 0.1}, ball);
    CHECK(seconds >= 0.0);
    scored += seconds > 0.0 ? 1 : 0;
  }
  CHECK(scored == 5);
}

TEST_CASE("libero's taker of a free ball drives straight at it, also where its mark is at our area's edge",
          "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const auto team = test::liberoIn(info);
  for (const double mark : {-0.375, 0.375}) {
    team->begin(info);
    Observation seen;
    seen.restart = RestartKind::kFreeBall;
    seen.since_restart = 0.0;
    seen.ball.position = {mark, -0.4};
    const Vec2 places[] = {{-0.71, 0.0}, {mark - 0.2, -0.4}, {-0.3, 0.3}};
    for (std::size_t i = 0; i < 3; ++i) {
      seen.own[i].present = seen.opponents[i].present = true;
      seen.own[i].state.pose.position = places[i];
      seen.opponents[i].state.pose = {{mark + 0.2 + 0.1 * static_cast<double>(i), -0.4}, math::kPi};
    }
    const Twist taker = team->decide(seen).robots[1].twist;
    CHECK(taker.linear > 0.9 * info.robot.maxSpeed());
    CHECK(std::abs(taker.angular) < 0.1);
  }
}

TEST_CASE("libero drives at a free ball from its mark beside the area", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const auto team = test::liberoIn(info);
  Observation seen;
  seen.own[0] = test::standingAt({{-0.71, 0.1}, 1.57});
  // nearer to the area than a robot may come during play
  seen.own[1] = test::standingAt({{-0.575, 0.4}, 0.0});
  seen.own[2] = test::standingAt({{0.1, 0.0}, 0.0});
  seen.opponents[0] = test::standingAt({{-0.175, 0.4}, 3.14});
  seen.ball.position = {-0.375, 0.4};
  seen.restart = RestartKind::kFreeBall;
  for (int i = 0; i < 6; ++i) {
    seen.since_restart = i / 60.0;
    const RobotCommand command = team->decide(seen).robots[1];
    CHECK(command.twist.linear > 0.9 * info.robot.maxSpeed());
    CHECK(std::abs(command.twist.angular) < 3.0);
  }
}

TEST_CASE("libero lets a free ball that is pinched between two slip out to the side wall", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  for (const double side : {1.0, -1.0}) {
    const auto team = test::liberoIn(info);
    Observation seen;
    seen.own[0] = test::standingAt({{-0.71, 0.0}, 1.57});
    seen.own[1] = test::standingAt({{-0.434, side * 0.4}, 0.0});
    seen.own[2] = test::standingAt({{0.1, 0.0}, 0.0});
    seen.opponents[0] = test::standingAt({{-0.316, side * 0.4}, math::kPi});
    seen.ball.position = {-0.375, side * 0.4};
    seen.restart = RestartKind::kFreeBall;
    Twist first, last;
    for (int i = 0; i < 24; ++i) {
      seen.tick = Tick{12} + i;
      seen.since_restart = static_cast<double>(seen.tick) / 60.0;
      last = team->decide(seen).robots[1].twist;
      if (i == 0) first = last;
    }
    CHECK(std::abs(first.angular) < 0.2);
    CHECK(last.angular * side > 1.0);
    CHECK(last.linear > 0.9 * info.robot.maxSpeed());
  }
}

TEST_CASE("libero squeezes a ball that is pressed at the wall of its half out of there", "[unit]") {
  Placement scene;
  scene.ball = {-0.62, 0.628};
  scene.robots[0][1] = Pose2{{-0.67, 0.57}, 0.66};
  scene.robots[1][1] = Pose2{{-0.56, 0.607}, -1.9};
  for (const double side : {1.0, -1.0}) {
    const Match match = test::playedFrom(test::mirrored(scene, side), 4.0, "chaser");
    CHECK(match.world().balls[0].position.x > scene.ball.x + 0.15);
    CHECK(match.referee().score[1] == 0);
  }
}

TEST_CASE("libero holds against one who presses on its ball head-on", "[unit]") {
  Placement scene;
  scene.ball = {-0.007, 0.046};
  scene.robots[0][1] = Pose2{{-0.069, 0.050}, -0.02};
  scene.robots[1][0] = Pose2{{0.053, 0.050}, 3.12};
  for (const double side : {1.0, -1.0}) {
    const Placement start = test::mirrored(scene, side);
    Match match = test::matchFrom(test::matchOf("libero", "chaser", "vsss-3v3", 10.0), start);
    // The direction in which the ball leaves the two robots must be sideways or upfield.
    Vec2 moved;
    while (norm(moved) < 0.04 && match.seconds() < 2.0 && match.step()) {
      moved = match.world().balls[0].position - start.ball;
    }
    CHECK(norm(moved) >= 0.04);
    CHECK(moved.x > -0.03);
  }
}

TEST_CASE("libero turns a ball in that runs along their end wall", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    for (const double y : {0.30, 0.34, 0.42}) {
      CAPTURE(side, y);
      CHECK(test::scoresAlone({0.7285, y}, {{0.68, y + 0.10}, -1.3}, side) < 3.0);
    }
  }
}

}  // namespace fulbito
