#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// What the first support does with the ball at rest at `ball` for `stuck` [s], or at a free ball.
std::optional<libero::Move> moveAt(const char* robot, Vec2 ball, double stuck, bool free_ball = false,
                                   int rank = 0) {
  const libero::Pitch pitch(test::infoOf(3, robot));
  Observation seen;
  seen.team_size = 3;
  seen.own[2] = test::standingAt({{-0.5, 0.0}, 0.0});
  seen.ball.position = ball;
  if (free_ball) seen.restart = RestartKind::kFreeBall, seen.since_restart = 0.1;
  libero::BallForecast forecast;
  forecast.take(seen.ball, {});
  libero::Picture picture{seen, pitch, forecast, stuck};
  picture.rank[2] = rank;
  libero::Memory memory;
  return libero::support::guardThrow(picture, 2, memory);
}

}  // namespace

TEST_CASE("libero's support stands where a free ball in our half would be thrown across", "[unit]") {
  const MatchInfo info = test::infoOf(3, "firasim");
  const libero::Pitch pitch(info);
  const Vec2 mark = info.field.free_ball_mark;
  for (const double side : {1.0, -1.0}) {
    const auto move = moveAt("firasim", {-0.7, side * 0.6}, 9.0);
    REQUIRE(move);
    REQUIRE(move->place);
    // A ball from the mark goes straight across, or toward our goal by twice `front` until the middle. It
    // touches the robot's face on either way.
    const Vec2 from{-mark.x, side * mark.y};
    for (const Vec2 to : {Vec2{from.x, 0.0}, Vec2{from.x - 2 * pitch.front, 0.0}}) {
      const Vec2 way = unitOr(to - from, {});
      const Vec2 rel = *move->place - from;
      CHECK(dot(rel, way) > 0.0);
      CHECK(std::abs(cross(way, rel)) < pitch.front + 1e-9);
    }
    // It leaves the robots at the mark alone.
    CHECK(distance(*move->place, from) > pitch.bodies + pitch.front);
  }
}

TEST_CASE("libero's support guards against throws only at free balls in our half, where nobody can shove",
          "[unit]") {
  const Vec2 corner{-0.7, 0.6}, mark{-0.375, 0.4};
  CHECK(moveAt("firasim", corner, 9.0));
  CHECK_FALSE(moveAt("firasim", corner, 7.0));
  CHECK(moveAt("firasim", mark, 0.0, true));
  CHECK_FALSE(moveAt("firasim", corner, 9.0, false, 1));
  CHECK_FALSE(moveAt("firasim", -mark, 0.0, true));
  CHECK_FALSE(moveAt("vsss", corner, 9.0));
  CHECK_FALSE(moveAt("vsss", mark, 0.0, true));
}

}  // namespace fulbito
