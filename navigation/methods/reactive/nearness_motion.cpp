#include "navigation/methods/reactive/nearness_motion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kSlowest = 0.2;  // least share of the top speed in low safety

NearnessMotion turnTowardGoal(const NearnessView& view) {
  NearnessMotion motion;
  motion.direction = view.goal.y >= 0.0 ? math::kPi / 2 : -math::kPi / 2;
  return motion;
}

NearnessSituation situationOf(const NearnessView& view, const WalkingArea& area, const SecurityZone& zone) {
  const bool left = zone.left < 1.0, right = zone.right < 1.0;
  if (left && right) return NearnessSituation::kLs2;
  if (left || right) return area.goal_inside ? NearnessSituation::kLsgr : NearnessSituation::kLs1;
  if (area.goal_inside) return NearnessSituation::kHsgr;
  return isWide(view, area) ? NearnessSituation::kHswr : NearnessSituation::kHsnr;
}

double directionIn(NearnessSituation situation, double wanted, const SecurityZone& zone) {
  if (situation == NearnessSituation::kLs2) return twoSidedDirection(wanted, zone);
  if (situation == NearnessSituation::kLs1 || situation == NearnessSituation::kLsgr) {
    return oneSidedDirection(wanted, zone);
  }
  return wanted;
}

bool isInFront(const NearnessHull& hull, Vec2 p) {
  const double corner = norm({hull.length / 2, hull.width / 2});
  return p.x > 0.0 && norm(p) < corner && std::abs(p.y) < hull.width / 2;
}

bool isBesideRear(const NearnessHull& hull, Vec2 p) {
  return p.x < 0.0 && p.x > -hull.length / 2 && std::abs(p.y) < hull.width / 2 + hull.margin / 2;
}

/// Suppresses a turn in which a rear corner, which swings out opposite to the turn, would hit something.
void applyEmergency(const NearnessView& view, const NearnessHull& hull, NearnessMotion& motion) {
  for (const SectorHit& hit : view.hits) {
    if (hit.isEmpty()) continue;
    motion.blocked = motion.blocked || isInFront(hull, hit.point);
    const bool towards = motion.direction * hit.point.y < 0.0;
    motion.turn_cut = motion.turn_cut || (towards && isBesideRear(hull, hit.point));
  }
  if (motion.turn_cut) motion.direction = 0.0;
  if (motion.blocked) motion.speed_share = 0.0;
}

}  // namespace

double NearnessHull::reach(Vec2 direction) const {
  const double x = std::abs(direction.x), y = std::abs(direction.y);
  return x * width > y * length ? length / 2 / x : width / 2 / y;
}

SecurityZone securityZone(const NearnessView& view, const NearnessHull& hull, double direction,
                          double horizon) {
  SecurityZone zone;
  const Vec2 way = math::unit(direction);
  double nearest = 1.0;
  for (int i = 0; i < view.circle->count(); ++i) {
    const SectorHit& hit = view.hits[static_cast<std::size_t>(i)];
    if (hit.isEmpty() || hit.distance > horizon) continue;
    const Vec2 bearing = view.circle->direction(i);
    const double free = std::max(0.0, hit.distance - hull.reach(bearing)) / view.security;
    if (free >= 1.0) continue;
    double& side = cross(way, bearing) >= 0.0 ? zone.left : zone.right;
    side = std::min(side, free);
    if (free < nearest) nearest = free, zone.nearest_bearing = view.circle->bearing(i);
  }
  return zone;
}

double oneSidedDirection(double wanted, const SecurityZone& zone) {
  const double away = wanted + math::wrapAngle(zone.nearest_bearing + math::kPi - wanted);
  const double c = zone.nearest();
  return math::wrapAngle(c * wanted + (1.0 - c) * away);
}

double twoSidedDirection(double wanted, const SecurityZone& zone) {
  const double half = math::kPi / 2, beta = std::clamp(wanted, -half, half);
  const double sum = zone.left + zone.right;
  const double excess = sum > 0.0 ? (zone.left - zone.right) / sum : 0.0;
  return beta + excess * (excess <= 0.0 ? beta + half : half - beta);
}

double roomAhead(std::span<const SectorHit> hits, double half_width) {
  double room = std::numeric_limits<double>::infinity();
  for (const SectorHit& hit : hits) {
    if (hit.point.x > 0.0 && std::abs(hit.point.y) < half_width) room = std::min(room, hit.point.x);
  }
  return room;
}

NearnessMotion decideNearness(const NearnessView& view, const NearnessHull& hull) {
  const WalkingArea area = findWalkingArea(view);
  NearnessMotion motion = turnTowardGoal(view);
  if (area.found) {
    const double wanted = area.goal_inside ? math::angleOf(view.goal) : areaDirection(view, area);
    const double horizon = area.goal_inside ? norm(view.goal) : std::numeric_limits<double>::infinity();
    const SecurityZone zone = securityZone(view, hull, wanted, horizon);
    motion.situation = situationOf(view, area, zone);
    motion.direction = std::clamp(directionIn(motion.situation, wanted, zone), -math::kPi / 2, math::kPi / 2);
    motion.speed_share = std::max(kSlowest, zone.nearest());
  }
  applyEmergency(view, hull, motion);
  return motion;
}

}  // namespace fulbito
