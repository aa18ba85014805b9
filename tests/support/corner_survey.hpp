#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "navigation/registry.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"

namespace fulbito::test {

/// What a method does on many corner layouts at one speed.
struct CornerSurvey {
  int runs = 0;
  int reached = 0;
  int safe = 0;         ///< reached without a touch
  double length = 0.0;  ///< [m] mean of the safe runs over the straight line from start to goal
  double time = 0.0;    ///< [s] mean of the safe runs
};

/// Runs `specification` on `count` layouts from `first_seed` on.
inline CornerSurvey surveyCorners(const std::string& specification, double speed, std::uint64_t first_seed,
                                  int count) {
  const auto pilot = makePilot(*parseNavigator(specification));
  const RobotModel robot = paperRobot(speed);
  const FieldGeometry field;
  CornerSurvey survey;
  survey.runs = count;
  for (int i = 0; i < count; ++i) {
    const CornerLayout layout = cornerLayout(first_seed + static_cast<std::uint64_t>(i));
    const auto run = kinematicTrial(**pilot, robot, field, layout.start, layout.goal, layout.obstacles);
    if (run.reached) ++survey.reached;
    if (!run.reached || run.touched) continue;
    ++survey.safe;
    survey.length += run.length / distance(layout.start.position, layout.goal.position);
    survey.time += run.time;
  }
  const double safe = std::max(1, survey.safe);
  survey.length /= safe;
  survey.time /= safe;
  return survey;
}

/// Prints one line a speed for 200 layouts.
inline void printCornerSurvey(const std::string& specification) {
  for (double speed : {0.6, 1.0, 2.6}) {
    const CornerSurvey s = surveyCorners(specification, speed, 0, 200);
    std::printf("%-40s %.1f m/s: reached %5.1f %%, safe %5.1f %%, L/L_straight %.3f, T %.3f s\n",
                specification.c_str(), speed, 100.0 * s.reached / s.runs, 100.0 * s.safe / s.runs, s.length,
                s.time);
  }
}

/// 99th percentile of the wall time [us] of one tick's `drive` among nine obstacles.
inline double tickTime99(const std::string& specification) {
  const auto pilot = makePilot(*parseNavigator(specification));
  const RobotModel robot = paperRobot(1.0);
  const FieldGeometry field;
  Rng rng(7, Stream::kTest);
  std::vector<double> times;
  for (int i = 0; i < 2000; ++i) {
    std::vector<DiscObstacle> obstacles;
    for (int k = 0; k < 9; ++k) {
      obstacles.push_back({{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)}, 0.0335, {}});
    }
    NavigationScene scene;
    scene.field = &field;
    scene.robot = &robot;
    scene.obstacles = obstacles;
    scene.goal.position = {rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)};
    scene.self.pose = {{rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)}, rng.uniform(-3.0, 3.0)};
    const auto begin = std::chrono::steady_clock::now();
    (*pilot)->drive(scene);
    const auto end = std::chrono::steady_clock::now();
    times.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
  }
  std::sort(times.begin(), times.end());
  return times[times.size() * 99 / 100];
}

}  // namespace fulbito::test
