#include "navigation/methods/paths/bezier_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "navigation/geometry/polyline.hpp"

namespace fulbito {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<double, 12> kDistances = {0.040, 0.064, 0.088, 0.112, 0.136, 0.160,
                                               0.200, 0.240, 0.290, 0.350, 0.420, 0.480};
// [m] from the goal to the control point behind it
constexpr std::array<double, 3> kLeads = {0.10, 0.20, 0.35};
constexpr double kSettled = 0.02;   // [m] before the goal with the arrival heading
constexpr double kMomentum = 0.08;  // [s] of motion along which the curve starts
constexpr double kInMotion = 0.15;  // [m/s]
constexpr std::size_t kCoarse = 8;  // samples between the points of a quick check
constexpr std::size_t kReserved = 64;

/// The smallest disc round two discs.
Circle enclosing(const Circle& a, const Circle& b) {
  const double apart = distance(a.centre, b.centre);
  if (apart + b.radius <= a.radius) return a;
  if (apart + a.radius <= b.radius) return b;
  const double radius = (apart + a.radius + b.radius) / 2;
  return {a.centre + (b.centre - a.centre) * ((radius - a.radius) / apart), radius};
}

/// Whether the last part of the curve has the arrival heading within half of its tolerance. A real robot,
/// which lags, would miss a heading that the curve reaches only at its very end.
bool arrivesAlong(std::span<const Vec2> path, const NavigationGoal& goal, double heading) {
  const Vec2 along = math::unit(heading);
  const double least = math::cos(goal.heading_tolerance / 2);
  for (std::size_t i = path.size() - 1; i > 0; --i) {
    if (distance(path[i], goal.position) > kSettled) return true;
    const Vec2 step = path[i] - path[i - 1];
    if (dot(step, along) < least * norm(step)) return false;
  }
  return true;
}

}  // namespace

BezierPlanner::BezierPlanner(BezierPlannerParams params) : params_(params) {
  selected_.reserve(kReserved);
  groups_.reserve(kReserved);
}

std::optional<std::size_t> BezierPlanner::plan(const NavigationScene& scene, std::span<const Circle> bodies,
                                               const TangentPath& shortest,
                                               std::span<const double> clearances) {
  const Vec2 robot = scene.self.pose.position, goal = scene.goal.position;
  const double radius = scene.robot->circumradius();
  open_levels_ = std::min(clearances.size(), kMostClearances);
  for (std::size_t i = 0; i < open_levels_; ++i) {
    levels_[i].guard.prepare(robot, goal, bodies, radius, clearances[i], *scene.field);
    levels_[i].length = levels_[i].to_beat = kInfinity;
  }
  selectObstacles(robot, goal, bodies, params_.alpha, selected_);
  do {
    group(scene, bodies, shortest);
    trySides(scene, 0);
    if (params_.all_sides || levels_[0].length == kInfinity) {
      for (Level& level : levels_) level.to_beat = level.length * (1.0 - params_.hysteresis);
      for (std::uint32_t flips = 1; flips < 1U << groups_.size(); ++flips) trySides(scene, flips);
    }
  } while (levels_[0].length == kInfinity && addNearest(scene, bodies));
  chosen_ = open_levels_ - 1;
  if (levels_[chosen_].length == kInfinity) return {};
  return chosen_;
}

void BezierPlanner::group(const NavigationScene& scene, std::span<const Circle> bodies,
                          const TangentPath& shortest) {
  groups_.clear();
  for (std::size_t i : selected_) groups_.push_back({bodies[i], {}});
  while (groups_.size() > kMostGroups) joinNearest();
  for (Group& g : groups_) {
    const Vec2 across = acrossLine(scene.self.pose.position, g.disc.centre);
    g.seed = seededSide(scene, shortest, g.disc.centre) > 0 ? across : -across;
  }
}

void BezierPlanner::joinNearest() {
  std::size_t best = 0;
  double least = kInfinity;
  for (std::size_t i = 0; i + 1 < groups_.size(); ++i) {
    const Circle &a = groups_[i].disc, &b = groups_[i + 1].disc;
    const double gap = distance(a.centre, b.centre) - a.radius - b.radius;
    if (gap < least) least = gap, best = i;
  }
  groups_[best].disc = enclosing(groups_[best].disc, groups_[best + 1].disc);
  groups_.erase(groups_.begin() + static_cast<std::ptrdiff_t>(best) + 1);
}

bool BezierPlanner::addNearest(const NavigationScene& scene, std::span<const Circle> bodies) {
  if (selected_.size() >= kMostGroups) return false;
  const Vec2 robot = scene.self.pose.position, goal = scene.goal.position;
  std::size_t best = bodies.size();
  double least = kInfinity;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (std::find(selected_.begin(), selected_.end(), i) != selected_.end()) continue;
    const double away = squaredDistanceToSegment(robot, goal, bodies[i].centre);
    if (away < least) least = away, best = i;
  }
  if (best == bodies.size()) return false;
  selected_.push_back(best);
  sortAlongLine(robot, goal, bodies, selected_);
  return true;
}

/// The side on which the shortest path passes a point, from the nearest segment of the path.
int BezierPlanner::seededSide(const NavigationScene& scene, const TangentPath& shortest, Vec2 centre) const {
  Vec2 from = scene.self.pose.position;
  double least = kInfinity, turn = 0.0;
  const auto look = [&](Vec2 to) {
    const double away = squaredDistanceToSegment(from, to, centre);
    if (away < least) least = away, turn = cross(to - from, centre - from);
    from = to;
  };
  for (const CirclePass& pass : shortest.passes()) {
    look(pass.entry);
    look(pass.exit);
  }
  look(scene.goal.position);
  return turn > 0.0 ? -1 : 1;
}

void BezierPlanner::trySides(const NavigationScene& scene, std::uint32_t flips) {
  std::array<Vec2, kBezierDegree + 1> control;
  const Vec2 robot = scene.self.pose.position;
  const Vec2 ahead = math::unit(scene.self.pose.heading);
  const double speed = dot(scene.self.velocity, ahead);
  for (double tbp : kDistances) {
    std::size_t count = 0;
    control[count++] = robot;
    if (speed > kInMotion) control[count++] = robot + ahead * (speed * kMomentum);
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      const double side = (flips >> i & 1U) != 0 ? -tbp : tbp;
      control[count++] = groups_[i].disc.centre + groups_[i].seed * side;
    }
    // The points of the curve move outward in proportion to the distance of the control points. Points that
    // are outside stay there.
    if (!tryEnds(scene, control, count) || groups_.empty()) break;
  }
}

bool BezierPlanner::tryEnds(const NavigationScene& scene, std::span<Vec2> control, std::size_t count) {
  if (!scene.goal.heading) {
    control[count++] = scene.goal.position;
    return tryCurve(scene, control.first(count));
  }
  const Vec2 along = math::unit(*scene.goal.heading);
  bool inside = false;
  for (double lead : kLeads) {
    const std::size_t all = addArrival(scene.goal.position, along, lead, control, count);
    inside = tryCurve(scene, control.first(all)) || inside;
  }
  return inside;
}

std::size_t BezierPlanner::addArrival(Vec2 goal, Vec2 along, double lead, std::span<Vec2> control,
                                      std::size_t count) const {
  const Vec2 last = control[count - 1], left = goal - last;
  const double before = dot(left, along), beside = cross(along, last - goal);
  // The control point close behind the goal must not be behind the robot, or the curve would turn back.
  if (std::abs(beside) < 0.6 * before) lead = std::min(lead, 0.6 * before);
  const Vec2 behind = goal - along * lead;
  if (dot(behind - last, along) < 0.0) {
    control[count++] = behind + perp(along) * std::copysign(2.0 * lead, beside);
  }
  control[count++] = behind;
  control[count++] = goal;
  return count;
}

bool BezierPlanner::tryCurve(const NavigationScene& scene, std::span<const Vec2> control) {
  // A few points show for most curves that they collide, leave the field or are too long: the chords are
  // shorter than the curve.
  const PathGuard& loosest = levels_[open_levels_ - 1].guard;
  std::array<Vec2, kBezierPoints / kCoarse + 1> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = bezierPoint(control, i * kCoarse);
    if (!loosest.clearAt(points[i])) return true;
  }
  if (!loosest.insideWalls(points)) return false;
  if (polylineLength(points) < levels_[0].to_beat) keepIfBest(scene, control);
  return true;
}

void BezierPlanner::keepIfBest(const NavigationScene& scene, std::span<const Vec2> control) {
  sampleBezier(control, trial_);
  if (scene.goal.heading && !arrivesAlong(trial_, scene.goal, *scene.goal.heading)) return;
  const double length = polylineLength(trial_);
  for (std::size_t i = 0; i < open_levels_; ++i) {
    Level& level = levels_[i];
    if (!(length < level.to_beat)) return;
    if (!level.guard.clear(trial_)) continue;
    if (!level.guard.insideWalls(control) && !level.guard.insideWalls(trial_)) return;
    level.length = level.to_beat = length;
    level.path = trial_;
    open_levels_ = i + 1;
    return;
  }
}

}  // namespace fulbito
