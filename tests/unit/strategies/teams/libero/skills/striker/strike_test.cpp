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

}  // namespace fulbito
