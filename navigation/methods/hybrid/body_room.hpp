#pragma once

#include <span>
#include <vector>

#include "navigation/obstacles/proven_map.hpp"

namespace fulbito {

/// Lengths of the sonar drive are given for a body of 7.5 cm width; those of `robot` are so many times
/// longer.
double bodySize(const RobotModel& robot);

/// What stands about the body, and how near it would come: the occupied cells of the map, and the quick
/// ranges of near echoes, which are there before the map has them.
class BodyRoom {
 public:
  /// @param smoothers  one a sensor of the scene, fed with this tick's readings
  void look(const NavigationScene& scene, const ProvenMap& map, std::span<const RangeSmoother> smoothers);
  /// Least distance [m] of the body to anything, at `place` (robot frame) and turned by `turn` [rad]; at most
  /// a few centimetres. Inside of the body it is negative.
  double at(Vec2 place, double turn) const;
  /// The same where the body stands.
  double here() const { return here_; }
  /// What a motion has to leave free [m]: `margin`, or what is free now.
  double floor(double margin) const { return margin < here_ ? margin : here_ - kSlack; }
  /// Whether the body can turn in place by what it turns in 0.1 s at `rate` [rad/s], at most by `most` [rad].
  bool turns(double rate, double most, double margin) const;
  /// Whether nothing is within `margin` [m] of the circle about the body.
  bool turnsFreely(double margin) const { return nearest_ > radius_ + margin; }

 private:
  static constexpr double kSlack = 0.0001;  // [m] rounding

  std::vector<Vec2> points_;
  double half_length_ = 0.0, half_width_ = 0.0, size_ = 1.0;
  double here_ = 0.0;
  double radius_ = 0.0, nearest_ = 0.0;
};

}  // namespace fulbito
