#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

namespace {

/// Whether robot 2, behind the striker by `behind` [m], joins it at `ball` in front of an opponent. `gap`
/// [m]: from ball to opponent. `rank`: its number among the robots without the ball.
bool joins(int size, BallState at, double gap, double behind, int rank = 0) {
  const libero::Pitch pitch(test::infoOf(size));
  const Vec2 place = at.position;
  Observation seen;
  seen.team_size = size;
  seen.ball = at;
  seen.own[1] = test::standingAt({place - Vec2{0.1, 0.0}, 0.0});
  seen.own[2] = test::standingAt({place - Vec2{behind, 0.2}, 0.0});
  seen.opponents[1] = test::standingAt({place + Vec2{gap, 0.0}, math::kPi});
  libero::BallForecast ball;
  ball.take(seen.ball, {});
  libero::Picture picture{seen, pitch, ball};
  picture.keeper = 0, picture.striker = 1;
  picture.rank[2] = rank;
  libero::Memory memory;
  const auto move = libero::support::join(picture, 2, memory);
  if (move) CHECK(move->twist.linear != 0.0);
  return move.has_value();
}

}  // namespace

TEST_CASE("the first support behind a ball that an opponent fights for plays it, too", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  const BallState open;
  BallState wall;
  wall.position.y = pitch.half_width - pitch.ball_radius - 0.001;
  CHECK(joins(3, wall, 0.1, 0.3));
  CHECK_FALSE(joins(3, open, 0.1, 0.3));
  CHECK(joins(5, open, 0.1, 0.3));
  CHECK_FALSE(joins(3, wall, 0.1, -0.3));  // ahead of the ball
  CHECK_FALSE(joins(3, wall, pitch.tuning.rival_far + 0.01, 0.3));
  BallState fast = wall;
  fast.velocity.x = pitch.tuning.pushable + 0.1;
  CHECK_FALSE(joins(3, fast, 0.1, 0.3));
}

TEST_CASE("in a large match a second support joins, but not a third", "[unit]") {
  BallState wall;
  wall.position.y = libero::Pitch(test::infoOf(5)).half_width - 0.022;
  CHECK(joins(5, wall, 0.1, 0.3, 1));
  CHECK_FALSE(joins(5, wall, 0.1, 0.3, 2));
  CHECK_FALSE(joins(3, wall, 0.1, 0.3, 1));
}

}  // namespace fulbito
