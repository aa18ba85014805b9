#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fulbito/navigation.hpp"
#include "navigation/geometry/circle.hpp"

namespace fulbito {

/// Additional distance [m] between the centres of `robot` and an obstacle, compared with a 7.5 cm square
/// robot and a tennis ball. The fields' distances are given for that pair and grow with larger bodies.
double extraSize(const DiscObstacle& obstacle, const RobotModel& robot);

/// A point's position relative to the way from `p` to `goal`.
struct OnWay {
  double along = 0.0;    ///< [m] from `p` to the point's foot on the line
  double lateral = 0.0;  ///< [m] off the line, positive to the left
  double length = 0.0;   ///< [m] length of the way
  bool between() const { return along > 0.0 && along < length; }
};
OnWay onWay(Vec2 point, Vec2 p, Vec2 goal);

/// The side on which the robot passes a circle.
enum class PassingSide { kUndecided, kLeft, kRight };
PassingSide opposite(PassingSide side);

/// Angles [rad] by which a robot must turn from the bearing to the goal to pass a group of circles on its
/// left or right. Negative if the group does not reach across the line.
struct Extents {
  double left = 0.0;
  double right = 0.0;
  PassingSide smaller() const { return left < right ? PassingSide::kLeft : PassingSide::kRight; }
};

/// How passing sides are decided.
struct SideRules {
  double hysteresis = 0.174533;           ///< [rad] advantage that the other side needs for a change
  const FieldGeometry* inside = nullptr;  ///< if set, sides that lead out of this field are avoided
  /// [m] distance from its walls at which a side counts as leading out
  double wall_margin = 0.0;
};

/// The circles of a scene, with overlapping ones joined to clusters. A cluster is passed on one side, which
/// is kept from tick to tick.
class ClusteredCircles {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void reset() { members_.clear(); }
  /// Starts a tick. Then call `add` for the circles, in the order of the last tick, and `join`.
  void begin(std::size_t count);
  void add(Circle circle) { members_[filled_++].circle = circle; }
  /// Finds the clusters.
  void join();
  /// Decides the side of each cluster in the way of a robot at `p`: the one with the smaller turn, kept
  /// within the hysteresis and forgotten after the cluster is passed.
  void decideSides(Vec2 p, Vec2 goal, const SideRules& rules);

  /// Index of the nearest circle with its centre within `range` [m] of `p` that the way from `p` to `goal`
  /// crosses.
  std::size_t nearestBlocking(Vec2 p, Vec2 goal, double range) const;
  const Circle& circle(std::size_t index) const { return members_[index].circle; }
  /// Extents of the cluster of circle `index` as seen from `p`. Members behind `p` or beyond `goal` do not
  /// count.
  Extents extents(std::size_t index, Vec2 p, Vec2 goal) const;
  /// The decided side of the cluster of circle `index`, or the one with the smaller turn at `p` if none is
  /// decided.
  PassingSide side(std::size_t index, Vec2 p, Vec2 goal) const;

 private:
  struct Member {
    Circle circle;
    std::size_t cluster = 0;  ///< lowest index of a circle in its cluster
    PassingSide side = PassingSide::kUndecided;
  };
  bool staysInside(std::size_t cluster, PassingSide side, Vec2 p, Vec2 goal, const SideRules& rules) const;
  PassingSide newSide(std::size_t cluster, Vec2 p, Vec2 goal, const SideRules& rules) const;

  std::vector<Member> members_;
  std::size_t filled_ = 0;
};

}  // namespace fulbito
