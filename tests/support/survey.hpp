#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "fulbito/navigation.hpp"
#include "tests/support/corner_layout.hpp"

namespace fulbito::test {

using LayoutMaker = std::function<CornerLayout(std::uint64_t seed)>;

/// What is driven in a survey.
struct SurveyTask {
  LayoutMaker layout = cornerLayout;
  double speed = 1.0;  ///< [m/s] top speed of paperRobot
  std::uint64_t first_seed = 0;
  int runs = 200;
  FieldGeometry field;
  double limit_clearance = 0.058;  ///< [m] that the shortest way L* keeps from the obstacles at rest
};

/// What a method does on many layouts with the kinematic robot.
struct Survey {
  int runs = 0;
  int reached = 0;
  int safe = 0;       ///< reached without a touch
  int own_fault = 0;  ///< drove into an obstacle
  /// @{ Means of the safe runs.
  double over_straight = 0.0;  ///< length over the straight line from start to goal
  double over_shortest = 0.0;  ///< length over L*
  double time = 0.0;           ///< [s]
  double over_bound = 0.0;     ///< time over that of L* from rest at 5 m/s^2
  double clearance = 0.0;      ///< [m] least of a run
  /// @}
  double worst_over_bound = 0.0;
  std::vector<double> tick_micros;  ///< [us] of all ticks
};

/// Drives the method that `specification` names.
Survey survey(const std::string& specification, const SurveyTask& task);

/// Prints a line for each of 0.6, 1.0 and 2.6 m/s, and one with the ticks' wall times.
void printSurvey(const std::string& name, const std::string& specification, SurveyTask task);

/// Prints the wall time of the first tick among `obstacles` balls, over 2000 random scenes.
void printPlanningTime(const std::string& specification, std::size_t obstacles);

}  // namespace fulbito::test
