#pragma once

#include <optional>
#include <span>

#include "navigation/methods/hybrid/crowding.hpp"
#include "navigation/obstacles/echo_circles.hpp"

namespace fulbito {

/// The way through between two bodies, world frame.
struct Passage {
  Vec2 middle;              ///< [m] of its narrowest place
  Vec2 axis;                ///< unit, through it
  double width = 0.0;       ///< [m] of its narrowest place
  double deviation = 0.0;   ///< [m] standard deviation of the width
  int left = 0, right = 0;  ///< names of the circles

  /// How far [m] `place` is beyond the narrowest place.
  double along(Vec2 place) const { return dot(place - middle, axis); }
  /// How far [m] `place` is to the left of the axis.
  double aside(Vec2 place) const { return cross(axis, place - middle); }
};

/// The passage between two circles, the one on the left first.
Passage passageBetween(const EchoCircles::Tracked& left, const EchoCircles::Tracked& right);

/// Leads a robot through a passage: along its axis from before it until the rear corners have left it.
class PassageGuide {
 public:
  void reset() { passage_.reset(); }
  /// Follows the circles of the present passage, or else starts with one of `gaps` that lies right ahead.
  /// Gives up where something stands in its middle.
  /// @param hits, gaps  what the robot sees, robot frame
  /// @param widest  [m] wider passages need no guide
  /// @param may_start  whether a new passage may be taken
  void update(const EchoCircles& circles, std::span<const SectorHit> hits, std::span<const NarrowGap> gaps,
              const NavigationScene& scene, double widest, bool may_start);
  bool isActive() const { return passage_.has_value(); }
  /// Direction [rad, world frame] toward the axis ahead of `place`; only while active.
  /// @param scale  of the robot, see `pioneerScale`
  double direction(Vec2 place, double scale) const;

 private:
  std::optional<Passage> present(const EchoCircles& circles, std::span<const SectorHit> hits,
                                 const NavigationScene& scene) const;

  std::optional<Passage> passage_;
};

}  // namespace fulbito
