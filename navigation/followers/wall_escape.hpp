#pragma once

#include "fulbito/navigation.hpp"

namespace fulbito {

/// Gets a robot away from a wall or corner that leaves it no room to turn (docs/navigators.md; Jung & Lee
/// 2015, Figs 4-5). It acts after the follower and only on a slow robot whose wanted turn would press its
/// body into a wall:
/// - the centre is within the body's circumradius + 2 cm of a wall, and the heading within 50 degrees of
///   straight at it or straight away from it; with two walls near, their diagonal counts as one wall and 75
///   degrees are allowed, as treating one wall at a time swings to and fro between them (Fig. 5);
/// - facing the wall, the robot backs out; facing away, it drives off. Its speed is a fifth of its top speed,
///   but at most 0.3 m/s, and it turns toward the goal as far as there is room;
/// - it ends when the body can turn freely, when the heading leaves the range by 10 degrees more, or after 1
///   s. In the last case the follower drives for at least half a second.
/// The escape does not act on a robot whose wanted twist leads straight into the wall or along it, or on one
/// whose way out an obstacle blocks.
class WallEscape {
 public:
  void reset();
  /// Returns the follower's twist `wanted`, or the escape's own twist.
  Twist apply(const NavigationScene& scene, Twist wanted);
  bool active() const { return direction_ != 0.0; }

 private:
  double direction_ = 0.0;  ///< +1 driving off forward, -1 backing out, 0 not escaping
  Tick since_ = 0;
  Tick rest_until_ = 0;
};

}  // namespace fulbito
