#pragma once

#include "experiments/papers/localization/estimation/initial_pose.hpp"
#include "experiments/papers/localization/rig.hpp"

namespace fulbito::localization {

/// What a robot finds out before it drives: steps 1 and 2 of the paper.
struct FirstFix {
  InitialPose start;
  double gyro_bias = 0.0;  ///< [rad/s] mean reading at standstill
  /// @{ [rad] where two simpler rules would have turned, from where the robot stands: the middle of the
  /// near-shortest echoes of the last sweep, and the paper's shortest echo of it.
  double level_centre = 0.0;
  double shortest_echo = 0.0;
  /// @}
};

/// Aligns the robot with a wall and finds its pose: gyro bias at standstill, a sweep of the front sensor by
/// +-45 degrees, sweeps of +-40 degrees about the middle of the near-shortest echoes until it stays, a turn
/// to the fitted perpendicular, and mean echoes at standstill. Errors: kBadInput if no wall answers, and as
/// `locate`.
/// @param range_noise  [m] of a range, as stated to the robot
Result<FirstFix> findStart(Rig& rig, const Room& room, double range_noise);

/// Echoes at standstill, and the deviation [m] of a mean distance for ranges of deviation `sigma`.
inline constexpr int kStandstillPings = 20;
double meanSigma(double sigma);

}  // namespace fulbito::localization
