#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "engine/core/base/values.hpp"

namespace fulbito {

/// A desired direction of travel at every point of the field.
class HeadingField {
 public:
  virtual ~HeadingField() = default;
  /// Direction [rad] of travel for a robot at `p`. Finite for every finite `p`.
  virtual double heading(Vec2 p) const = 0;
};

enum class GuidanceKind {
  kField,      ///< `field` is set
  kPath,       ///< `path` is set; the follower chooses the speed
  kTimedPath,  ///< `path` and `speeds` are set: the method planned its own speed profile
  kWheels,     ///< `wheels` is set: the method controls the robot itself
};

/// A navigator's output. Views point into the navigator and stay valid until its next call.
struct Guidance {
  GuidanceKind kind = GuidanceKind::kField;
  const HeadingField* field = nullptr;
  std::span<const Vec2> path;      ///< [m] robot's place to goal, at least 2 points, any spacing
  std::span<const double> speeds;  ///< [m/s] at each path point
  std::uint64_t revision = 0;      ///< changes whenever `path` or `speeds` do, so that followers can cache
  WheelSpeeds wheels;              ///< [rad/s]
  double speed_cap = std::numeric_limits<double>::infinity();  ///< [m/s] present speed limit
};

/// Guidance by `field`, which must outlive it.
inline Guidance guidanceBy(const HeadingField& field) {
  Guidance guidance;
  guidance.kind = GuidanceKind::kField;
  guidance.field = &field;
  return guidance;
}

}  // namespace fulbito
