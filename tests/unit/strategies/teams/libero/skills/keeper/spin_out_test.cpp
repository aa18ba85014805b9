#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/keeper/keeper_at.hpp"

namespace fulbito {
namespace {

/// Goals against a team in 96 pushes along its end wall that come with a run-up.
int conceded(const char* team) {
  int goals = 0;
  for (const char* opponent : {"classic", "univector", "presser"}) {
    for (int run = 0; run < 32; ++run) {
      const double side = run % 2 ? 1.0 : -1.0, y = -0.36 - 0.03 * (run / 2 % 4),
                   x = -0.728 + 0.02 * (run / 8);
      Placement scene;
      scene.ball = {x, y};
      scene.robots[0] = {test::keeperAt({-0.708, -0.178}, side), Pose2{{0.2, 0.3}, 0.0},
                         Pose2{{0.2, -0.3}, 0.0}};
      scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{x + 0.02, y - 0.15}, math::kPi / 2}};
      MatchConfig config = test::matchOf(team, opponent, "vsss-3v3", 10.0);
      Match match = test::matchFrom(config, test::mirrored(scene, side));
      while (match.seconds() < 2.0 && match.step()) {
      }
      goals += match.referee().score[1];
    }
  }
  return goals;
}

}  // namespace

TEST_CASE("libero's keeper spins out most balls that opponents would push in past its post", "[unit]") {
  const int with = conceded("libero"), without = conceded("libero:without=spin-out");
  CAPTURE(with, without);
  CHECK(2 * with < without);
}

TEST_CASE("libero's keeper spins beside a ball that an opponent presses on at the post, and nowhere else",
          "[unit]") {
  // The yaw rate of the skill's answer; 0 if it has none.
  const auto spin = [](Vec2 keeper, Vec2 ball, Vec2 opponent, const char* robot = "vsss") {
    const libero::Pitch pitch(test::infoOf(3, robot));
    Observation seen;
    seen.team_size = 3;
    seen.own[0] = test::standingAt({keeper, math::kPi / 2});
    seen.opponents[1] = test::standingAt({opponent, 0.0});
    seen.ball.position = ball;
    libero::BallForecast forecast;
    forecast.take(seen.ball, {});
    libero::Memory memory;
    const auto move = libero::keeper::spinOut({seen, pitch, forecast}, 0, memory);
    return move ? move->twist.angular : 0.0;
  };
  const Vec2 keeper{-0.708, 0.15}, ball{-0.728, 0.21}, opponent{-0.70, 0.28};
  // The face at the ball moves into the field.
  CHECK(spin(keeper, ball, opponent) < 0.0);
  CHECK(spin({-0.708, -0.15}, {-0.728, -0.21}, {-0.70, -0.28}) > 0.0);
  CHECK(spin(keeper, ball, {-0.3, 0.28}) == 0.0);
  CHECK(spin(keeper, {-0.65, 0.17}, opponent) == 0.0);               // in front of the keeper
  CHECK(spin({-0.708, 0.0}, {-0.71, 0.06}, {-0.65, 0.1}) == 0.0);    // within the mouth
  CHECK(spin({-0.708, 0.3}, {-0.728, 0.36}, {-0.70, 0.43}) == 0.0);  // far from the post
  CHECK(spin(keeper, ball, opponent, "firasim") == 0.0);             // nobody can shove it
}

}  // namespace fulbito
