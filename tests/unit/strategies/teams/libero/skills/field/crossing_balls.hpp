#pragma once

#include "fulbito/detail/math.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito::test {

/// Goals of 24 trials: a ball rolls across in front of a guarded goal, at `x` [m] or up to 6 cm farther, to a
/// robot with a run-up behind it.
inline int goalsFromCrossingBalls(const char* team, const char* robot, double x = 0.40) {
  int scored = 0;
  for (int trial = 0; trial < 24; ++trial) {
    const double side = trial % 2 == 0 ? 1.0 : -1.0, part = trial / 2 / 11.0;
    auto config = matchOf(team, "univector", "vsss-3v3", 10.0);
    config.robot = *loadRobot(robot);
    Placement scene;
    scene.ball = {x + 0.06 * part, 0.35};
    scene.ball_velocity = {0.05, -0.45 - 0.15 * part};
    scene.robots[0][0] = Pose2{{-0.7, 0.0}, math::kPi / 2};
    scene.robots[0][1] = Pose2{{x - 0.38 + 0.06 * part, -0.35}, 0.0};
    scene.robots[1][0] = Pose2{{0.7, 0.05}, math::kPi / 2};
    Match match = matchFrom(config, mirrored(scene, side));
    while (match.seconds() < 3.0 && match.referee().score[0] == 0 && match.step()) {
    }
    scored += match.referee().score[0] > 0 ? 1 : 0;
  }
  return scored;
}

}  // namespace fulbito::test
