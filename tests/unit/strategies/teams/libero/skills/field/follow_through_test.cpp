#include <optional>

#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/field/crossing_balls.hpp"

namespace fulbito {
namespace {

/// Robot and ball, as seen by the robot's team.
struct Chase {
  Vec2 robot{0.30, 0.10}, speed{0.9, 0.0}, ball{0.37, 0.10}, rolls{0.8, 0.0};
};

std::optional<libero::Move> followed(const Chase& chase, const char* model = "firasim",
                                     double spin_left = 0.0, RestartKind restart = RestartKind::kKickOff,
                                     std::optional<Vec2> opponent = std::nullopt) {
  const libero::Pitch pitch(test::infoOf(3, model));
  Observation seen;
  seen.team_size = 3;
  seen.restart = restart;
  seen.own[1] = test::standingAt({chase.robot, 0.0});
  seen.own[1].state.velocity = chase.speed;
  if (opponent) seen.opponents[2] = test::standingAt({*opponent, 0.0});
  seen.ball.position = chase.ball;
  seen.ball.velocity = chase.rolls;
  libero::BallForecast ball;
  ball.take(seen.ball, {});
  libero::Memory memory;
  memory.spin.left = spin_left;
  return libero::field::followThrough({seen, pitch, ball}, 1, memory);
}

}  // namespace

TEST_CASE("libero's robot pushes a ball on that rolls at their goal right in front of it", "[unit]") {
  const auto move = followed({});
  REQUIRE(move);
  CHECK(move->target->x == Approx(0.75));
  CHECK(move->target->y == Approx(0.10));
  CHECK(move->twist.linear > 1.5);
  CHECK(followed({}, "vsss"));
}

TEST_CASE("libero's robot pushes a ball on that would miss the mouth if an opponent could take it",
          "[unit]") {
  const Chase past_the_post{.ball = {0.37, 0.12}, .rolls = {0.8, 0.3}};
  const auto with_opponent_at = [&](std::optional<Vec2> place) {
    return followed(past_the_post, "firasim", 0.0, RestartKind::kKickOff, place);
  };
  // Toward the mouth, if that is a small turn.
  const auto turned = with_opponent_at(Vec2{0.5, 0.2});
  REQUIRE(turned);
  CHECK(turned->target->y < 0.2);
  CHECK(turned->twist.angular > 0.0);
  CHECK_FALSE(with_opponent_at(Vec2{0.7, 0.0}));
  CHECK_FALSE(with_opponent_at(std::nullopt));
}

TEST_CASE("libero's robot does not follow other balls", "[unit]") {
  CHECK_FALSE(followed({.robot = {-0.10, 0.10}, .ball = {-0.03, 0.10}}));  // in our half
  CHECK_FALSE(followed({.ball = {0.45, 0.10}}));                           // far ahead
  CHECK_FALSE(followed({.ball = {0.35, 0.15}}));                           // beside it
  CHECK_FALSE(followed({.ball = {0.24, 0.10}}));                           // behind it
  CHECK_FALSE(followed({.rolls = {0.05, 0.0}}));                           // lies
  CHECK_FALSE(followed({.rolls = {-0.5, 0.0}}));                           // comes back
  CHECK_FALSE(
      followed({.rolls = {0.5, 0.6}}, "firasim", 0.0, RestartKind::kKickOff, Vec2{0.5, 0.2}));  // goes wide
  CHECK_FALSE(followed({.speed = {0.1, 0.0}}));                      // the robot stands
  CHECK_FALSE(followed({.speed = {0.0, 0.9}}));                      // drives past it
  CHECK_FALSE(followed({}, "firasim", 0.2));                         // spins
  CHECK_FALSE(followed({}, "firasim", 0.0, RestartKind::kPenalty));  // has aimed
}

TEST_CASE("libero scores more often from volleys that it follows", "[unit]") {
  const int with = test::goalsFromCrossingBalls("libero", "firasim", 0.34);
  const int without = test::goalsFromCrossingBalls("libero:without=follow-through", "firasim", 0.34);
  CAPTURE(with, without);
  CHECK(with >= without + 5);
}

}  // namespace fulbito
