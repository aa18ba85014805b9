#pragma once

#include "experiments/papers/localization/estimation/room.hpp"

namespace fulbito::localization {

/// Where an aligned robot faces. The paper takes -y and -x; +y and +x are the same rooms turned by half.
enum class Facing { kMinusY, kMinusX };

/// The constant with which the paper turns echo time into distance before it knows better [m/s]: half the
/// speed of sound at 14 degrees.
inline constexpr double kNominalEchoSpeed = 170.0;

/// Its relative error at `celsius` [degrees].
double nominalError(double celsius);

/// Limits [m/s] of half the speed of sound: from 5 to 35 degrees.
struct EchoSpeedBand {
  double low = 0.0;   ///< at 5 degrees
  double high = 0.0;  ///< at 35 degrees
};
EchoSpeedBand echoSpeedBand();

/// An axis, and the constant from time to distance that follows from it.
struct AxisDecision {
  Facing facing = Facing::kMinusY;
  double echo_speed = 0.0;  ///< [m/s] K of (2-1) or (2-2): metres to the wall per second of echo time
};

/// The side distance that a facing spans: the room's extent across it.
constexpr double acrossOf(const Room& room, Facing facing) {
  return facing == Facing::kMinusY ? room.x : room.y;
}

/// The paper's rule: the extent that is nearer to the width seen with the nominal constant.
/// @param side_time  [s] echo times of both sides together
Facing nearestFacing(const Room& room, const Body& body, double side_time);

/// @{ Least difference [m] of the extents at which a rule tells the axes of a room apart at every temperature
/// of the band, the longer extent given: the paper's rule, without noise, and `decideAxis`.
/// @param sigma  [m] standard deviation of both side distances together
double nearestSeparation(double longer, const Body& body);
double bandSeparation(double longer, const Body& body, double sigma);
/// @}

/// Whether echoes at any temperature of the band tell the two axes of a room apart.
/// @param sigma  [m] standard deviation of both side distances together
/// Errors: kBadInput with the least difference of the extents that is needed.
Result<void> checkUnambiguous(const Room& room, const Body& body, double sigma);

/// The axis for which the constant lies within the band of temperatures, 4 sigma allowed for noise.
/// Errors: kBadInput if both or neither do.
Result<AxisDecision> decideAxis(const Room& room, const Body& body, double side_time, double sigma);

}  // namespace fulbito::localization
