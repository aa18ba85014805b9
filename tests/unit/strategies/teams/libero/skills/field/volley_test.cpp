#include <optional>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/foresight.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/field/crossing_balls.hpp"

namespace fulbito {
namespace {

/// Whether robot 1 plays a volley at a ball that rolls across, `since` [s] after a restart, with an opponent
/// at `other` [m], if any.
bool answers(RestartKind restart, double since, std::optional<Vec2> other) {
  const MatchInfo info = test::infoOf(3, "firasim");
  const libero::Pitch pitch(info);
  Observation seen;
  seen.team_size = 3;
  seen.restart = restart;
  seen.since_restart = since;
  seen.own[1] = test::standingAt({{0.05, -0.35}, 0.0});
  if (other) seen.opponents[0] = test::standingAt({*other, math::kPi / 2});
  seen.ball = {{0.42, 0.3}, {0.05, -0.5}, {0.05, -0.5}};
  BallPrediction way;
  way.predict(BallCourse(info.field, info.ball, info.physics), seen.ball);
  libero::BallForecast ball;
  ball.take(seen.ball, way);
  libero::Memory memory;
  return libero::field::volley({seen, pitch, ball}, 1, memory).has_value();
}

}  // namespace

TEST_CASE("libero plays volleys against opponents, and not at the start of a penalty", "[unit]") {
  const Vec2 kept{0.7, 0.15}, out{0.2, 0.5};
  CHECK(answers(RestartKind::kFreeBall, 0.8, kept));
  CHECK(answers(RestartKind::kFreeBall, 0.8, out));
  CHECK_FALSE(answers(RestartKind::kFreeBall, 0.8, std::nullopt));
  CHECK_FALSE(answers(RestartKind::kPenalty, 0.8, kept));
  CHECK(answers(RestartKind::kPenalty, 3.0, kept));
}

TEST_CASE("a robot that speeds up slowly shoots a crossing ball on the run", "[unit]") {
  const int with = test::goalsFromCrossingBalls("libero", "firasim"),
            without = test::goalsFromCrossingBalls("libero:without=volley", "firasim");
  CAPTURE(with, without);
  CHECK(with >= 12);
  CHECK(with >= without + 6);
  CHECK(test::goalsFromCrossingBalls("libero", "vsss") ==
        test::goalsFromCrossingBalls("libero:without=volley", "vsss"));
}

}  // namespace fulbito
