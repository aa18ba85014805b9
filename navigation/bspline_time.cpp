#include "navigation/bspline_time.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/math.hpp"
#include "navigation/limiter.hpp"

namespace fulbito {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAtRest = 0.15;        // [m/s] slower than that a start may turn in place
constexpr double kArrived = 0.9;        // of the goal's tolerance
constexpr double kOffPath = 0.03;       // [m] from the path that asks for a new plan
constexpr double kSharpTurn = 0.26;     // cosine of the turn that is better made at rest
constexpr double kMeanSpeed = 0.6;      // of the top speed, to guess where moving discs are met
constexpr double kFirstStep = 0.02;     // [m] of the pattern search
constexpr double kDetour = 1.12;        // length of another way that is worth a try
constexpr double kGapGain = 0.97;       // length of a way through a narrow gap that is worth a try
constexpr int kTrialEvaluations = 6;    // of a way on the other side
constexpr std::size_t kTrialBends = 2;  // bends whose other side is tried
constexpr int kMovingTrials = 4;        // the same among moving discs, where plans are short-lived
constexpr std::size_t kMovingBends = 1;
constexpr int kReplanTicks = 4;       // least age of a plan that is dropped
constexpr double kEasyPace = 0.4;     // [m/s] that a waiting robot may set off with
constexpr double kCreep = 0.08;       // [m/s]
constexpr double kPassing = 1.2;      // [m/s] through a goal with a wanted heading
constexpr double kBrakeRoom = 0.1;    // [m]
constexpr double kTurnTime = 0.25;    // [s] a radian, before a robot that faces aside speeds up
constexpr double kDisplaced = 0.01;   // [m] that a disc at rest may be moved before a plan is looked at again
constexpr double kWholePath = 20.0;   // [s]
constexpr double kSoon = 0.8;         // [s] within which moving discs make the robot slow down
constexpr double kBraceSpeed = 0.7;   // [m/s] from which it can stop in time
constexpr double kBraceGap = 0.003;   // [m] nearer than that it is touched already and shall come free
constexpr double kBraceTime = 0.05;   // [s] beyond the time to stop
constexpr double kTightPass = 0.015;  // [m] by moving discs that waiting may better
constexpr std::array<double, 2> kSlower{0.5, 0.4};  // of the speed before
constexpr int kConflictTicks = 8;                   // least age of a plan that a conflict replaces
constexpr int kCalmTicks = 20;                      // age at which a plan that gives way is made anew

}  // namespace

BsplineTime::BsplineTime(Params params) : params_(params) {
  now_.reserve(64);
  planned_.reserve(64);
}

void BsplineTime::reset() {
  path_.clear();
  planned_once_ = false;
  braking_ = false;
  missed_heading_ = false;
}

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
  if (braking_) return norm(scene.self.velocity) < kAtRest;
  if (age_ < kReplanTicks) return false;
  // A plan that gives way is for a moment only.
  if (best_task_.limits.max_speed < scene.robot->maxSpeed() && age_ >= kCalmTicks) return true;
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

SeedRequest BsplineTime::setTask(const NavigationScene& scene, double speed) {
  const Vec2 facing = math::unit(scene.self.pose.heading);
  const bool moving = speed > kAtRest && dot(scene.self.velocity, facing) > 0.0;
  task_.limits = speedLimits(*scene.robot, params_.acceleration_share, params_.lateral_share);
  task_.limits.start_speed = moving ? speed : 0.0;
  task_.body = bodyShape(*scene.robot);
  task_.clearance_wish = params_.clearance;
  task_.clearance_least = params_.least_clearance;
  task_.field = scene.field;
  task_.discs = planned_;
  task_.start_direction = moving ? std::nullopt : std::optional(facing);

  SeedRequest request;
  request.start = scene.self.pose.position;
  if (moving) request.start_direction = scene.self.velocity / speed;
  request.goal = scene.goal.position;
  request.speed = kMeanSpeed * scene.robot->maxSpeed();
  return request;
}

void BsplineTime::makePlan(const NavigationScene& scene) {
  goal_ = scene.goal;
  planned_once_ = true;
  age_ = 0;
  spent_ = 0;
  braking_ = false;
  planned_ = now_;
  ++revision_;

  const double speed = norm(scene.self.velocity);
  const SeedRequest request = setTask(scene, speed);
  best_ = {};
  if (!scene.goal.heading) {
    choose(scene, request, Arrival::kFree);
  } else {
    if (!missed_heading_ && !scene.goal.stop) choose(scene, request, Arrival::kThrough);
    choose(scene, request, Arrival::kTurn);
  }
  if (any_moves_ && best_.score().clearance < kTightPass) trySlower();
  if (request.start_direction && best_.best().controls() > 2) {
    const Vec2 first = unitOr(best_.best().control(2) - best_.best().control(1), *request.start_direction);
    if (dot(first, *request.start_direction) < kSharpTurn) return brake(scene, speed);
  }
  path_.clear();
  path_.build(best_.best(), best_task_.limits);
}

void BsplineTime::choose(const NavigationScene& scene, const SeedRequest& request, Arrival arrival) {
  SeedRequest wanted = request;
  task_.limits.end_speed = arrival == Arrival::kTurn || scene.goal.stop ? 0.0
                           : arrival == Arrival::kThrough               ? kPassing
                                                                        : 1e9;
  task_.end_direction.reset();
  if (scene.goal.heading) {
    const Vec2 direction = math::unit(*scene.goal.heading);
    if (arrival == Arrival::kThrough) wanted.end_direction = direction;
    if (arrival == Arrival::kTurn) task_.end_direction = direction;
  }
  cost_.setTask(task_);
  const bool found =
      seeder_.search(wanted, *scene.robot, *scene.field, planned_, SplineSeeder::Room::kTurning);
  const double length = found ? seeder_.length() : kInfinity;
  if (found) tryWays();
  if (found && seeder_.bends() == 0) return;
  // A gap that only a straight robot fits through is worth it where the way around is long.
  if (seeder_.search(wanted, *scene.robot, *scene.field, planned_, SplineSeeder::Room::kStraight)
          ? seeder_.length() < kGapGain * length
          : !found) {
    tryWays();
  }
}

void BsplineTime::tryWays() {
  tryCandidate(seeder_.shortest());
  CubicSpline other;
  const std::size_t bends = std::min(seeder_.bends(), any_moves_ ? kMovingBends : kTrialBends);
  for (std::size_t bend = 0; bend < bends; ++bend) {
    if (seeder_.otherSide(bend, kDetour, other)) tryCandidate(other);
  }
}

void BsplineTime::tryCandidate(const CubicSpline& seed) {
  const bool through = task_.limits.end_speed > 0.0 && goal_.heading.has_value();
  candidate_.start(seed, task_.start_direction ? 1 : 2, through ? 2 : 1, kFirstStep);
  int trials = candidate_.improve(cost_, 1);
  // A straight way in the open is as good as it gets.
  const bool straight = seeder_.bends() == 0 && task_.start_direction && !through;
  if (!straight || candidate_.score().clearance < params_.clearance) {
    trials += candidate_.improve(cost_, any_moves_ ? kMovingTrials : kTrialEvaluations);
  } else {
    trials = params_.effort;
  }
  spent_ += trials;
  if (best_.best().controls() == 0 || candidate_.score().cost < best_.score().cost) {
    best_ = candidate_;
    best_task_ = task_;
  }
}

void BsplineTime::trySlower() {
  const CubicSpline way = best_.best();
  task_ = best_task_;
  for (const double share : kSlower) {
    task_.limits.max_speed = share * best_task_.limits.max_speed;
    cost_.setTask(task_);
    tryCandidate(way);
    if (best_.score().clearance >= kTightPass) break;
  }
}

void BsplineTime::brake(const NavigationScene& scene, double speed) {
  braking_ = true;
  // Twice the braking distance: a robot beyond the end of its path would turn back to it.
  const double length = kBrakeRoom + speed * speed / std::max(scene.robot->wheel_acceleration, 0.1);
  path_.brake(scene.self.pose.position, math::unit(scene.self.pose.heading), length);
}

void BsplineTime::refine() {
  const int effort = any_moves_ ? params_.moving_effort : params_.effort;
  if (spent_ >= effort || best_.converged()) return;
  // The spans that the robot is in or about to enter keep their shape; a start at rest may still turn.
  if (path_.place() > 2) best_.freezeBefore(path_.span() + 3);
  cost_.setTask(best_task_);
  const double before = best_.score().cost;
  const int used = best_.improve(cost_, std::min(params_.evaluations, effort - spent_));
  spent_ = used > 0 ? spent_ + used : effort;
  if (best_.score().cost < before) {
    path_.build(best_.best(), best_task_.limits);
    ++revision_;
  }
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
  return path_.conflict(ride, task_.body, now_);
}

double BsplineTime::guard(const NavigationScene& scene) {
  if (!any_moves_) {
    if (age_ >= kConflictTicks && discsChanged() && conflictAt(scene, kInfinity, kWholePath) < kInfinity) {
      makePlan(scene);
    }
    return kInfinity;
  }
  // A touch that can no more be avoided shall at least not be the robot's doing.
  if (braces(scene)) return cap_ = 0.0;
  // Every second look is enough: in a tick a robot goes five centimetres at most.
  if (age_ == 0 || scene.tick % 2 == 0) cap_ = slowDown(scene);
  return cap_;
}

bool BsplineTime::braces(const NavigationScene& scene) const {
  const double speed = norm(scene.self.velocity);
  if (speed > kBraceSpeed) return false;
  const Vec2 facing = math::unit(scene.self.pose.heading);
  const double horizon = kBraceTime + speed / std::max(scene.robot->wheel_acceleration, 0.1);
  return std::any_of(now_.begin(), now_.end(), [&](const ForecastDisc& disc) {
    const double gap =
        discClearance(task_.body, scene.self.pose.position, facing, disc.position, disc.radius);
    return disc.moves && gap > kBraceGap &&
           meetsWithin(task_.body, scene.self.pose.position, facing, scene.self.velocity, disc, horizon);
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
