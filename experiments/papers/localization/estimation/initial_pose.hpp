#pragma once

#include <array>

#include "experiments/papers/localization/estimation/axis_decision.hpp"

namespace fulbito::localization {

/// Where an aligned robot stands.
struct InitialPose {
  AxisDecision axis;
  Pose2 pose;  ///< of its centre
  /// Covariance of x [m], y [m] and the constant [m/s], row by row: all three come from the same echoes.
  std::array<double, 9> covariance{};
};

/// Pose of the centre of an aligned robot, (1) of the paper with both of its lines made right.
Pose2 poseFacing(const AxisDecision& axis, const EchoTimes& times, const Body& body);

/// Axis, constant and pose of an aligned robot from its mean echo times.
/// @param sigma  [m] standard deviation of each mean distance
/// Errors: kBadInput without an echo of each sensor, as `decideAxis`, and if the front wall is farther than
/// the room allows.
Result<InitialPose> locate(const Room& room, const Body& body, const EchoTimes& times, double sigma);

}  // namespace fulbito::localization
