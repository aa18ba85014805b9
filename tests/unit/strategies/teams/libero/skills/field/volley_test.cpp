#include <optional>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/foresight.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// Goals of 24 trials: a ball rolls across in front of a guarded goal, to a robot with a run-up behind it.
int goals(const char* team, const char* robot) {
  int scored = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const double side = trial % 2 == 0 ? 1.0 : -1.0, part = trial / 2 / 11.0;
    auto config = test::matchOf(team, "univector", "vsss-3v3", 10.0);
    config.robot = *loadRobot(robot);
    Placement scene;
    scene.ball = {0.40 + 0.06 * part, 0.35};
    scene.ball_velocity = {0.05, -0.45 - 0.15 * part};
    scene.robots[0][0] = Pose2{{-0.7, 0.0}, math::kPi / 2};
    scene.robots[0][1] = Pose2{{0.02 + 0.06 * part, -0.35}, 0.0};
    scene.robots[1][0] = Pose2{{0.7, 0.05}, math::kPi / 2};
    Match match = test::matchFrom(config, test::mirrored(scene, side));
    while (match.seconds() < 3.0 && match.referee().score[0] == 0 && match.step()) {
    }
    scored += match.referee().score[0] > 0 ? 1 : 0;
  }
  return scored;
}

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
  const int with = goals("libero", "firasim"), without = goals("libero:without=volley", "firasim");
  CAPTURE(with, without);
  CHECK(with >= 12);
  CHECK(with >= without + 6);
  CHECK(goals("libero", "vsss") == goals("libero:without=volley", "vsss"));
}

}  // namespace fulbito
