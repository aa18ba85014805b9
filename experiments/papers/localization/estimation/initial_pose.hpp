#pragma once

#include <array>

#include "experiments/papers/localization/estimation/axis_decision.hpp"

namespace fulbito::localization {

/// The pose of an aligned robot.
struct InitialPose {
  AxisDecision axis;
  Pose2 pose;  ///< pose of its centre
  /// Covariance of x [m], y [m] and the constant [m/s], row by row. All three come from the same echoes.
  std::array<double, 9> covariance{};
};

/// Pose of the centre of an aligned robot: (1) of the paper with both of its lines corrected.
Pose2 poseFacing(const AxisDecision& axis, const EchoTimes& times, const Body& body);

/// Axis, constant and pose of an aligned robot from its mean echo times.
/// @param sigma  [m] standard deviation of each mean distance
/// Errors: kBadInput if a sensor has no echo or the front wall is farther away than the room allows, and as
/// `decideAxis`.
Result<InitialPose> locate(const Room& room, const Body& body, const EchoTimes& times, double sigma);

}  // namespace fulbito::localization
