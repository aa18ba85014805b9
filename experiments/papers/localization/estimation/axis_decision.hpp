#pragma once

#include "experiments/papers/localization/estimation/room.hpp"

namespace fulbito::localization {

/// The direction of an aligned robot. The paper uses -y and -x; +y and +x are the same rooms turned by 180
/// degrees.
enum class Facing { kMinusY, kMinusX };

/// The paper's initial constant [m/s] from echo time to distance: half the speed of sound at 14 degrees.
inline constexpr double kNominalEchoSpeed = 170.0;

/// Relative error of `kNominalEchoSpeed` at `celsius` [degrees].
double nominalError(double celsius);

/// Limits [m/s] of half the speed of sound, for 5 to 35 degrees.
struct EchoSpeedBand {
  double low = 0.0;   ///< at 5 degrees
  double high = 0.0;  ///< at 35 degrees
};
EchoSpeedBand echoSpeedBand();

/// An axis, and the constant from echo time to distance that follows from it.
struct AxisDecision {
  Facing facing = Facing::kMinusY;
  double echo_speed = 0.0;  ///< [m/s] K of (2-1) or (2-2): distance to the wall per echo time
};

/// The room's extent [m] across a facing, which the side sensors measure.
constexpr double acrossOf(const Room& room, Facing facing) {
  return facing == Facing::kMinusY ? room.x : room.y;
}

/// The paper's rule: the facing whose extent is nearer to the width measured with the nominal constant.
/// @param side_time  [s] sum of the echo times of both sides
Facing nearestFacing(const Room& room, const Body& body, double side_time);

/// @{ Least difference [m] of the extents with which a rule identifies the axes at every temperature of the
/// band, for a given longer extent: by the paper's rule without noise, and by `decideAxis`.
/// @param sigma  [m] standard deviation of the sum of both side distances
double nearestSeparation(double longer, const Body& body);
double bandSeparation(double longer, const Body& body, double sigma);
/// @}

/// Whether echoes identify the axes of a room at every temperature of the band.
/// @param sigma  [m] standard deviation of the sum of both side distances
/// Errors: kBadInput with the least difference of the extents that is necessary.
Result<void> checkUnambiguous(const Room& room, const Body& body, double sigma);

/// The axis whose constant is within the band of temperatures, with 4 sigma for noise.
/// Errors: kBadInput if both or neither do.
Result<AxisDecision> decideAxis(const Room& room, const Body& body, double side_time, double sigma);

}  // namespace fulbito::localization
