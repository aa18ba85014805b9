#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/driven.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

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
    const Twist taker = test::twistOf(info, team->decide(seen).robots[1]);
    CHECK(taker.linear == Approx(info.robot.wheel_acceleration / 60.0));
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
    const Twist taker = test::twistOf(info, team->decide(seen).robots[1]);
    CHECK(taker.linear > 0.9 * info.robot.wheel_acceleration / 60.0);
    CHECK(std::abs(taker.angular) < 3.0);
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
      last = test::twistOf(info, team->decide(seen).robots[1]);
      if (i == 0) first = last;
    }
    CHECK(std::abs(first.angular) < 0.2);
    CHECK(last.angular * side > 1.0);
    CHECK(last.linear > 0.5 * info.robot.wheel_acceleration / 60.0);
  }
}

TEST_CASE(
    "libero leaves a free ball of its half to strikes unless it is behind it, and one of theirs only ahead "
    "of it",
    "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  const auto disputes = [&](double x, Vec2 own) {
    Observation seen;
    seen.restart = RestartKind::kFreeBall;
    seen.ball.position = {x, 0.4};
    seen.own[0] = test::standingAt({seen.ball.position + own, 0.0});
    seen.opponents[0] = test::standingAt({seen.ball.position + Vec2{0.06, 0.0}, math::kPi});
    libero::BallForecast forecast;
    forecast.take(seen.ball, {});
    libero::Memory memory;
    return libero::striker::freeBall({seen, pitch, forecast}, 0, memory).has_value();
  };
  const Vec2 behind{-0.06, 0.0}, beside{-0.02, -0.06}, ahead{0.02, -0.06};
  for (const double x : {-0.375, 0.375}) {
    CHECK(disputes(x, behind));
    CHECK(disputes(x, beside) == (x > 0.0));
    CHECK_FALSE(disputes(x, ahead));
  }
}

TEST_CASE("where robots cannot push each other away, libero spins a free ball past their goal", "[unit]") {
  const MatchInfo info = test::infoOf(3, "firasim");
  for (const double side : {1.0, -1.0}) {
    const auto team = test::liberoIn(info);
    Observation seen;
    seen.team_size = 3;
    seen.own[0] = test::standingAt({{-0.71, 0.0}, 1.57});
    seen.own[1] = test::standingAt({{0.316, side * 0.4}, 0.0});
    seen.own[2] = test::standingAt({{0.1, 0.0}, 0.0});
    seen.opponents[0] = test::standingAt({{0.434, side * 0.4}, math::kPi});
    seen.ball.position = {0.375, side * 0.4};
    seen.restart = RestartKind::kFreeBall;
    seen.since_restart = 0.5;
    const Twist taker = test::twistOf(info, team->decide(seen).robots[1]);
    CHECK(taker.angular * side == Approx(-info.robot.turnAcceleration() / 60.0));
  }
}

TEST_CASE("the taker of a free ball drives on only while it is behind the ball", "[unit]") {
  const auto drivesOn = [](const char* robot, Vec2 taker) {
    const libero::Pitch pitch(test::infoOf(3, robot));
    Observation seen;
    seen.own[1] = test::standingAt({taker, 0.0});
    seen.opponents[0] = test::standingAt({{0.45, 0.45}, math::kPi});
    seen.ball.position = {0.36, 0.5};
    seen.restart = RestartKind::kFreeBall;
    seen.since_restart = 1.0;
    libero::BallForecast ball;
    ball.take(seen.ball, {});
    libero::Memory memory;
    return libero::striker::freeBall({seen, pitch, ball}, 1, memory).has_value();
  };
  for (const char* robot : {"vsss", "firasim"}) {
    CAPTURE(robot);
    CHECK(drivesOn(robot, {0.28, 0.5}));
    CHECK_FALSE(drivesOn(robot, {0.36, 0.42}));
    CHECK_FALSE(drivesOn(robot, {0.42, 0.5}));
  }
}

TEST_CASE("libero comes gently to a free ball that their keeper leaves", "[unit]") {
  const MatchInfo info = test::infoOf(3, "firasim");
  const libero::Pitch pitch(info);
  const auto speedFor = [&](const char* robot, Vec2 mark, double heading, double leaves) {
    const libero::Pitch on(test::infoOf(3, robot));
    Observation seen;
    seen.own[1] = test::standingAt({mark - Vec2{0.07, 0.0}, 0.0});
    seen.opponents[0] = test::standingAt({mark + Vec2{0.2, 0.0}, heading});
    seen.opponents[0].state.velocity = {leaves, 0.0};
    seen.ball.position = mark;
    seen.restart = RestartKind::kFreeBall;
    seen.since_restart = 0.3;
    libero::BallForecast ball;
    ball.take(seen.ball, {});
    libero::Memory memory;
    const auto move = libero::striker::freeBall({seen, on, ball}, 1, memory);
    REQUIRE(move);
    return move->twist.linear;
  };
  const Vec2 mark{0.375, 0.4};
  const double driven = pitch.speed;
  CHECK(speedFor("firasim", mark, math::kPi, 0.0) == Approx(driven));
  // It has turned to its goal, or drives back without a turn.
  CHECK(speedFor("firasim", mark, 2.2, 0.0) < driven / 2);
  CHECK(speedFor("firasim", mark, math::kPi, 0.4) < driven / 2);
  // In our half, and where robots push each other away, the ball has to go.
  CHECK(speedFor("firasim", {-0.375, 0.4}, 2.2, 0.0) == Approx(driven));
  CHECK(speedFor("vsss", mark, 2.2, 0.0) == Approx(libero::Pitch(test::infoOf(3)).speed));
}

TEST_CASE("libero throws a free ball that their keeper took, also if no opponent holds it", "[unit]") {
  const auto spins = [](const char* robot, double mark, double gap, bool kept = false) {
    const MatchInfo match = test::infoOf(3, robot);
    const libero::Pitch pitch(match);
    const auto team = test::liberoIn(match);
    Observation seen;
    seen.team_size = 3;
    seen.own[0] = test::standingAt({{-0.71, 0.0}, 1.57});
    seen.own[1] = test::standingAt({{mark - pitch.front - gap, 0.4}, 0.0});
    seen.own[2] = test::standingAt({{0.1, 0.0}, 0.0});
    seen.opponents[0] = test::standingAt({{mark + 0.2, 0.4}, 2.2});
    if (kept) seen.opponents[1] = test::standingAt({{0.71, 0.0}, 1.57});
    seen.ball.position = {mark, 0.4};
    seen.restart = RestartKind::kFreeBall;
    seen.since_restart = 0.5;
    const Twist taker = test::twistOf(match, team->decide(seen).robots[1]);
    return taker.angular == Approx(-match.robot.turnAcceleration() / 60.0);
  };
  CHECK(spins("firasim", 0.375, 0.003));
  CHECK_FALSE(spins("firasim", 0.375, 0.02));
  CHECK_FALSE(spins("firasim", 0.375, 0.003, true));
  CHECK_FALSE(spins("firasim", -0.375, 0.003));
  CHECK_FALSE(spins("vsss", 0.375, 0.003));
}

}  // namespace fulbito
