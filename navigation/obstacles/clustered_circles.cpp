#include "navigation/obstacles/clustered_circles.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kBallRadius = 0.0335;
constexpr double kRobotCircumradius = 0.0375 * std::numbers::sqrt2;

/// Half the angle [rad] of a circle as seen from a distance. From inside, it grows beyond a right angle up to
/// pi at the centre, so that the direction of its edge changes smoothly.
double halfWidth(const Circle& circle, double distance_to_centre) {
  if (distance_to_centre > circle.radius) return math::asin(circle.radius / distance_to_centre);
  return math::kPi / 2 * (2.0 - distance_to_centre / circle.radius);
}

bool blocks(const Circle& circle, Vec2 p, Vec2 goal) {
  const OnWay place = onWay(circle.centre, p, goal);
  return place.between() && std::abs(place.lateral) < circle.radius;
}

}  // namespace

double extraSize(const DiscObstacle& obstacle, const RobotModel& robot) {
  return (obstacle.radius - kBallRadius) + (robot.circumradius() - kRobotCircumradius);
}

OnWay onWay(Vec2 point, Vec2 p, Vec2 goal) {
  const double length = distance(p, goal);
  const Vec2 along = unitOr(goal - p, {});
  return {dot(along, point - p), cross(along, point - p), length};
}

PassingSide opposite(PassingSide side) {
  if (side == PassingSide::kUndecided) return side;
  return side == PassingSide::kLeft ? PassingSide::kRight : PassingSide::kLeft;
}

void ClusteredCircles::begin(std::size_t count) {
  members_.resize(count);
  filled_ = 0;
}

void ClusteredCircles::join() {
  const std::size_t count = members_.size();
  for (std::size_t i = 0; i < count; ++i) members_[i].cluster = i;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Circle &a = members_[i].circle, &b = members_[j].circle;
      const std::size_t one = members_[i].cluster, other = members_[j].cluster;
      if (one == other || distance(a.centre, b.centre) >= a.radius + b.radius) continue;
      for (Member& m : members_) {
        if (m.cluster == std::max(one, other)) m.cluster = std::min(one, other);
      }
    }
  }
}

Extents ClusteredCircles::extents(std::size_t index, Vec2 p, Vec2 goal) const {
  const double bearing = math::angleOf(goal - p);
  Extents widest{-math::kPi, -math::kPi};
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const Member& m = members_[i];
    if (m.cluster != members_[index].cluster) continue;
    if (i != index && !onWay(m.circle.centre, p, goal).between()) continue;
    const Vec2 to_centre = m.circle.centre - p;
    const double angle = math::wrapAngle(math::angleOf(to_centre) - bearing);
    const double half = halfWidth(m.circle, norm(to_centre));
    widest.left = std::max(widest.left, half + angle);
    widest.right = std::max(widest.right, half - angle);
  }
  return widest;
}

PassingSide ClusteredCircles::side(std::size_t index, Vec2 p, Vec2 goal) const {
  const PassingSide decided = members_[index].side;
  return decided != PassingSide::kUndecided ? decided : extents(index, p, goal).smaller();
}

std::size_t ClusteredCircles::nearestBlocking(Vec2 p, Vec2 goal, double range) const {
  std::size_t nearest = kNone;
  double least = range;
  for (std::size_t i = 0; i < members_.size(); ++i) {
    const double away = distance(p, members_[i].circle.centre);
    if (away < least && blocks(members_[i].circle, p, goal)) least = away, nearest = i;
  }
  return nearest;
}

bool ClusteredCircles::staysInside(std::size_t cluster, PassingSide side, Vec2 p, Vec2 goal,
                                   const SideRules& rules) const {
  if (rules.inside == nullptr) return true;
  const Vec2 left = perp(unitOr(goal - p, {}));
  const Vec2 outward = side == PassingSide::kLeft ? left : -left;
  for (const Member& m : members_) {
    if (m.cluster != cluster || !onWay(m.circle.centre, p, goal).between()) continue;
    if (wallClearance(*rules.inside, m.circle.centre + outward * m.circle.radius) < rules.wall_margin) {
      return false;
    }
  }
  return true;
}

PassingSide ClusteredCircles::newSide(std::size_t cluster, Vec2 p, Vec2 goal, const SideRules& rules) const {
  bool ahead = false, blocking = false;
  PassingSide side = PassingSide::kUndecided;
  std::size_t seen = cluster;
  for (std::size_t i = members_.size(); i-- > cluster;) {
    const Member& m = members_[i];
    if (m.cluster != cluster) continue;
    if (m.side != PassingSide::kUndecided) side = m.side;
    if (onWay(m.circle.centre, p, goal).between()) ahead = true, seen = i;
    blocking = blocking || blocks(m.circle, p, goal);
  }
  if (!ahead || (side == PassingSide::kUndecided && !blocking)) return PassingSide::kUndecided;
  const Extents turn = extents(seen, p, goal);
  if (side == PassingSide::kUndecided || std::abs(turn.left - turn.right) > rules.hysteresis)
    side = turn.smaller();
  if (!staysInside(cluster, side, p, goal, rules) && staysInside(cluster, opposite(side), p, goal, rules)) {
    side = opposite(side);
  }
  return side;
}

void ClusteredCircles::decideSides(Vec2 p, Vec2 goal, const SideRules& rules) {
  for (std::size_t cluster = 0; cluster < members_.size(); ++cluster) {
    if (members_[cluster].cluster != cluster) continue;
    const PassingSide side = newSide(cluster, p, goal, rules);
    for (Member& m : members_) {
      if (m.cluster == cluster) m.side = side;
    }
  }
}

}  // namespace fulbito
