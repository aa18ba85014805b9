#pragma once

#include "experiments/papers/localization/estimation/initial_pose.hpp"
#include "experiments/papers/localization/rig.hpp"

namespace fulbito::localization {

/// What a robot measures before it drives: steps 1 and 2 of the paper.
struct FirstFix {
  InitialPose start;
  double gyro_bias = 0.0;  ///< [rad/s] mean reading at standstill
  /// @{ [rad] directions by two simpler rules, relative to the robot's final heading: the middle of the
  /// near-shortest echoes of the last sweep, and its shortest echo (the paper's rule).
  double level_centre = 0.0;
  double shortest_echo = 0.0;
  /// @}
};

/// Aligns the robot with a wall and finds its pose. It measures the gyro bias at standstill and sweeps the
/// front sensor by +-45 degrees. Then it sweeps by +-40 degrees about the middle of the near-shortest echoes
/// until the middle stays. It turns to the fitted perpendicular and averages echoes at standstill. Errors:
/// kBadInput if no wall answers, and as `locate`.
/// @param range_noise  [m] standard deviation of a range, as the robot knows it
Result<FirstFix> findStart(Rig& rig, const Room& room, double range_noise);

/// Number of echoes at standstill, and the standard deviation [m] of their mean distance for ranges with
/// `sigma`.
inline constexpr int kStandstillPings = 20;
double meanSigma(double sigma);

}  // namespace fulbito::localization
