#include "experiments/papers/localization/estimation/axis_decision.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/sensors.hpp"

namespace fulbito::localization {
namespace {

constexpr double kColdest = 5.0, kWarmest = 35.0;  // [degrees]
constexpr double kSigmas = 4.0;

double echoSpeed(const Room& room, const Body& body, Facing facing, double side_time) {
  return (acrossOf(room, facing) - body.width) / side_time;
}

/// Whether some temperature in the band and a likely noise explain the side times.
bool fits(const Room& room, const Body& body, Facing facing, double side_time, double sigma) {
  const double between = acrossOf(room, facing) - body.width;
  const EchoSpeedBand band = echoSpeedBand();
  return between >= band.low * side_time - kSigmas * sigma &&
         between <= band.high * side_time + kSigmas * sigma;
}

}  // namespace

double nominalError(double celsius) { return kNominalEchoSpeed / (speedOfSound(celsius) / 2) - 1.0; }

EchoSpeedBand echoSpeedBand() { return {speedOfSound(kColdest) / 2, speedOfSound(kWarmest) / 2}; }

Facing nearestFacing(const Room& room, const Body& body, double side_time) {
  const double seen = kNominalEchoSpeed * side_time + body.width;
  return std::abs(seen - room.x) < std::abs(seen - room.y) ? Facing::kMinusY : Facing::kMinusX;
}

double nearestSeparation(double longer, const Body& body) {
  // In the warmest air the room seems smaller by this share. The extents must differ by twice as much.
  return -2 * nominalError(kWarmest) * (longer - body.width);
}

double bandSeparation(double longer, const Body& body, double sigma) {
  const EchoSpeedBand band = echoSpeedBand();
  // In the warmest air the longer side seems shortest. Even then the shorter side must not explain it.
  const double shortest_seen = (longer - body.width - kSigmas * sigma) * band.low / band.high;
  return longer - (shortest_seen - kSigmas * sigma + body.width);
}

Result<void> checkUnambiguous(const Room& room, const Body& body, double sigma) {
  const double longer = std::max(room.x, room.y), difference = std::abs(room.x - room.y);
  const double needed = bandSeparation(longer, body, sigma);
  if (difference > needed) return {};
  return fail(ErrorCode::kBadInput,
              fmt::format("room {:.3f} x {:.3f} m is ambiguous: its extents differ by {:.0f} mm, but between "
                          "{:.0f} and {:.0f} degrees echoes need more than {:.0f} mm",
                          room.x, room.y, difference * 1e3, kColdest, kWarmest, needed * 1e3));
}

Result<AxisDecision> decideAxis(const Room& room, const Body& body, double side_time, double sigma) {
  const bool along_y = fits(room, body, Facing::kMinusY, side_time, sigma);
  const bool along_x = fits(room, body, Facing::kMinusX, side_time, sigma);
  if (along_y != along_x) {
    const Facing facing = along_y ? Facing::kMinusY : Facing::kMinusX;
    return AxisDecision{facing, echoSpeed(room, body, facing, side_time)};
  }
  return fail(ErrorCode::kBadInput,
              fmt::format("{} of the room {:.3f} x {:.3f} m fits the side echoes of {:.0f} us: {:.4f} or "
                          "{:.4f} mm/us",
                          along_y ? "either axis" : "no axis", room.x, room.y, side_time * 1e6,
                          echoSpeed(room, body, Facing::kMinusY, side_time) * 1e-3,
                          echoSpeed(room, body, Facing::kMinusX, side_time) * 1e-3));
}

}  // namespace fulbito::localization
