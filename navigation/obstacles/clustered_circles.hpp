#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "fulbito/navigation.hpp"
#include "navigation/geometry/circle.hpp"

namespace fulbito {

/// How much farther [m] the centre of `robot` must keep from the obstacle's centre than that of a 7.5 cm
/// square robot from a tennis ball's: the fields' distances are given for that pair and grow with larger
/// bodies.
double extraSize(const DiscObstacle& obstacle, const RobotModel& robot);

/// Where a point lies as seen on the way from `p` to `goal`.
struct OnWay {
  double along = 0.0;    ///< [m] of its foot on the line, from `p`
  double lateral = 0.0;  ///< [m] off the line, left positive
  double length = 0.0;   ///< [m] of the way
  bool between() const { return along > 0.0 && along < length; }
};
OnWay onWay(Vec2 point, Vec2 p, Vec2 goal);

/// On which side of a circle the robot passes.
enum class PassingSide { kUndecided, kLeft, kRight };
PassingSide opposite(PassingSide side);

/// Angles [rad] by which a robot must turn from the bearing to the goal to pass a group of circles on its
/// left or right; negative where the group does not reach over the line.
struct Extents {
  double left = 0.0;
  double right = 0.0;
  PassingSide smaller() const { return left < right ? PassingSide::kLeft : PassingSide::kRight; }
};

/// How the passing sides are decided.
struct SideRules {
  double hysteresis = 0.174533;           ///< [rad] by which the other side must be better to change to it
  const FieldGeometry* inside = nullptr;  ///< when set, sides that lead out of this field are avoided ...
  double wall_margin = 0.0;               ///< [m] ... or nearer than this to its walls
};

/// The circles of a scene with the overlapping ones joined to clusters, each of which is passed on one side
/// that is kept from tick to tick.
class ClusteredCircles {
 public:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);

  void reset() { members_.clear(); }
  /// Starts a tick: the circles, in the order of the last tick, follow by `add` and end with `join`.
  void begin(std::size_t count);
  void add(Circle circle) { members_[filled_++].circle = circle; }
  /// Finds the clusters.
  void join();
  /// Decides the side of each cluster in the way of a robot at `p`: the one that needs the smaller turn, kept
  /// within the hysteresis and forgotten once the cluster is passed.
  void decideSides(Vec2 p, Vec2 goal, const SideRules& rules);

  /// Nearest circle, with its centre within `range` [m] of `p`, that the way from `p` to `goal` crosses.
  std::size_t nearestBlocking(Vec2 p, Vec2 goal, double range) const;
  const Circle& circle(std::size_t index) const { return members_[index].circle; }
  /// Of the cluster of circle `index` seen from `p`; members behind `p` or beyond `goal` do not count.
  Extents extents(std::size_t index, Vec2 p, Vec2 goal) const;
  /// The decided side of the cluster of circle `index`, or else the one with the smaller turn at `p`.
  PassingSide side(std::size_t index, Vec2 p, Vec2 goal) const;

 private:
  struct Member {
    Circle circle;
    std::size_t cluster = 0;  ///< lowest index in its cluster
    PassingSide side = PassingSide::kUndecided;
  };
  bool staysInside(std::size_t cluster, PassingSide side, Vec2 p, Vec2 goal, const SideRules& rules) const;
  PassingSide newSide(std::size_t cluster, Vec2 p, Vec2 goal, const SideRules& rules) const;

  std::vector<Member> members_;
  std::size_t filled_ = 0;
};

}  // namespace fulbito
