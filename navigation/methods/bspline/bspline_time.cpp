#include "navigation/methods/bspline/bspline_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "navigation/followers/limiter.hpp"

namespace fulbito {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kArrived = 0.9;     // share of the goal's tolerance at which the robot has arrived
constexpr double kOffPath = 0.03;    // [m] a robot farther from the path gets a new plan
constexpr int kReplanTicks = 4;      // least age of a plan before it is replaced
constexpr double kEasyPace = 0.4;    // [m/s] basis of speed caps for a robot that waits
constexpr double kCreep = 0.08;      // [m/s]
constexpr double kBrakeRoom = 0.1;   // [m]
constexpr double kTurnTime = 0.25;   // [s/rad] before a robot that faces aside accelerates
constexpr double kDisplaced = 0.01;  // [m] motion of a disc at rest after which the plan is checked again
constexpr double kWholePath = 20.0;  // [s]
constexpr double kSoon = 0.8;        // [s] time ahead in which conflicts slow the robot down
constexpr double kBraceSpeed = 0.7;  // [m/s] a slower robot can stop in time
constexpr double kBraceGap = 0.003;  // [m] a nearer disc touches: the robot should move away
constexpr double kBraceTime = 0.05;  // [s] added to the time to stop
constexpr int kConflictTicks = 8;    // least age of a plan before a conflict replaces it
constexpr int kCalmTicks = 20;       // age at which a plan at reduced speed is replaced

}  // namespace

BsplineTime::BsplineTime(Params params) : params_(params), planner_(params) {
  now_.reserve(64);
  planned_.reserve(64);
}

void BsplineTime::reset() {
  path_.clear();
  planned_once_ = false;
  braking_ = false;
  missed_heading_ = false;
}

// Tolerates more than ReplanMonitor: a plan that many ticks have improved is better than a new one, and a
// distant goal may drift.
bool BsplineTime::goalMoved(const NavigationScene& scene) const {
  const NavigationGoal& goal = scene.goal;
  const double slack = 0.5 * goal.tolerance + 0.05 * distance(scene.self.pose.position, goal.position);
  if (!(distance(goal.position, goal_.position) <= slack)) return true;
  if (goal.stop != goal_.stop || goal.heading.has_value() != goal_.heading.has_value()) return true;
  return goal.heading &&
         std::abs(math::wrapAngle(*goal.heading - *goal_.heading)) > goal.heading_tolerance / 2;
}

bool BsplineTime::needsPlan(const NavigationScene& scene, double off_path) const {
  if (!planned_once_ || goalMoved(scene)) return true;
  if (braking_) return norm(scene.self.velocity) < SplinePlanner::kAtRest;
  if (age_ < kReplanTicks) return false;
  // A plan at reduced speed is temporary.
  if (planner_.task().limits.max_speed < scene.robot->maxSpeed() && age_ >= kCalmTicks) return true;
  const bool arrived =
      distance(scene.self.pose.position, scene.goal.position) <= kArrived * scene.goal.tolerance;
  return !arrived && (off_path > kOffPath || path_.finished());
}

Guidance BsplineTime::plan(const NavigationScene& scene) {
  any_moves_ = forecast(scene, now_);
  ++age_;
  const double off_path = path_.advanceTo(scene.self.pose.position);
  if (needsPlan(scene, off_path)) {
    missed_heading_ = planned_once_ && path_.finished() && scene.goal.heading.has_value();
    makePlan(scene);
  } else if (!braking_) {
    refine();
  }
  Guidance guidance;
  guidance.speed_cap = guard(scene);
  guidance.kind = GuidanceKind::kTimedPath;
  guidance.path = path_.points();
  guidance.speeds = path_.speeds();
  guidance.revision = revision_;
  return guidance;
}

void BsplineTime::brake(const NavigationScene& scene, double speed) {
  braking_ = true;
  // Twice the braking distance, because a robot beyond the end of its path would turn back to it.
  const double length = kBrakeRoom + speed * speed / std::max(scene.robot->wheel_acceleration, 0.1);
  path_.brake(scene.self.pose.position, math::unit(scene.self.pose.heading), length);
}

void BsplineTime::makePlan(const NavigationScene& scene) {
  goal_ = scene.goal;
  planned_once_ = true;
  age_ = 0;
  braking_ = false;
  planned_ = now_;
  ++revision_;
  planner_.plan(scene, planned_, any_moves_, missed_heading_);
  if (planner_.turnsSharply()) return brake(scene, norm(scene.self.velocity));
  path_.clear();
  path_.build(planner_.spline(), planner_.task().limits);
}

void BsplineTime::refine() {
  // The spans that the robot is in or about to enter keep their shape. At the start all spans may change.
  const std::size_t first_free = path_.place() > 2 ? path_.span() + 3 : 0;
  if (!planner_.improve(any_moves_, first_free)) return;
  path_.build(planner_.spline(), planner_.task().limits);
  ++revision_;
}

bool BsplineTime::discsChanged() const {
  if (now_.size() != planned_.size()) return true;
  for (std::size_t i = 0; i < now_.size(); ++i) {
    if (planned_[i].moves || distance(now_[i].position, planned_[i].position) > kDisplaced) return true;
  }
  return false;
}

double BsplineTime::conflictAt(const NavigationScene& scene, double top, double horizon) const {
  DrivePath::Ride ride;
  ride.speed = std::max(0.0, bodyTwist(scene.self).linear);
  ride.top = top;
  ride.horizon = horizon;
  const double agreement = dot(path_.directionAhead(), math::unit(scene.self.pose.heading));
  ride.hold = kTurnTime * std::sqrt(std::max(0.0, 2.0 - 2.0 * agreement));
  ride.end = path_.length() - scene.goal.tolerance;
  ride.acceleration = params_.acceleration_share * scene.robot->wheel_acceleration;
  return path_.conflict(ride, planner_.task().body, now_);
}

double BsplineTime::guard(const NavigationScene& scene) {
  if (!any_moves_) {
    if (age_ >= kConflictTicks && discsChanged() && conflictAt(scene, kInfinity, kWholePath) < kInfinity) {
      makePlan(scene);
    }
    return kInfinity;
  }
  // If a collision is unavoidable, stop, so that this robot is not the one that causes it.
  if (collisionUnavoidable(scene)) return cap_ = 0.0;
  // Every second tick is enough: the robot moves at most five centimetres in a tick.
  if (age_ == 0 || scene.tick % 2 == 0) cap_ = slowDown(scene);
  return cap_;
}

bool BsplineTime::collisionUnavoidable(const NavigationScene& scene) const {
  const double speed = norm(scene.self.velocity);
  if (speed > kBraceSpeed) return false;
  const Vec2 facing = math::unit(scene.self.pose.heading);
  const double horizon = kBraceTime + speed / std::max(scene.robot->wheel_acceleration, 0.1);
  return std::any_of(now_.begin(), now_.end(), [&](const ForecastDisc& disc) {
    const double gap =
        discClearance(planner_.task().body, scene.self.pose.position, facing, disc.position, disc.radius);
    return disc.moves && gap > kBraceGap &&
           meetsWithin(planner_.task().body, scene.self.pose.position, facing, scene.self.velocity, disc,
                       horizon);
  });
}

double BsplineTime::slowDown(const NavigationScene& scene) {
  double clear = conflictAt(scene, kInfinity, kSoon);
  if (clear == kInfinity) return kInfinity;
  if (age_ >= kConflictTicks) {
    makePlan(scene);
    clear = conflictAt(scene, kInfinity, kSoon);
    if (clear == kInfinity) return kInfinity;
  }
  double best_cap = kInfinity;
  const double pace = std::max(norm(scene.self.velocity), kEasyPace);
  for (const double cap : {0.6 * pace, 0.3 * pace, kCreep, 0.0}) {
    const double until = conflictAt(scene, cap, kSoon);
    if (until > clear) clear = until, best_cap = cap;
    if (until == kInfinity) break;
  }
  return best_cap;
}

NavigatorInfo bsplineTimeInfo() {
  using P = BsplineTime::Params;
  return describeNavigator<P, BsplineTime>(
      "bspline-time", "cubic B-spline optimised for travel time", "future work of Jung & Lee 2015; own",
      {number("clearance", &P::clearance, 0.0, 0.2, "m", "of the robot's square that a plan pays time for"),
       number("least-clearance", &P::least_clearance, 0.001, 0.1, "m", "below it a plan counts as blocked"),
       number("acceleration-share", &P::acceleration_share, 0.1, 1.0, "",
              "of the wheel acceleration that plans use"),
       number("lateral-share", &P::lateral_share, 0.1, 1.0, "", "of the lateral grip that plans use"),
       integer("evaluations", &P::evaluations, 1, 10000, "splines judged a tick while improving a plan"),
       integer("effort", &P::effort, 1, 1000000, "splines judged a plan at most"),
       integer("moving-effort", &P::moving_effort, 1, 1000000, "the same among moving obstacles")},
      true);
}

}  // namespace fulbito
