#include "navigation/methods/bspline/spline_planner.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kSharpTurn = 0.26;     // cosine; the robot makes a sharper turn at rest
constexpr double kMeanSpeed = 0.6;      // share of the top speed, to guess where moving discs are met
constexpr double kFirstStep = 0.02;     // [m] initial step of the pattern search
constexpr double kDetour = 1.12;        // greatest relative length of another way that is tried
constexpr double kGapGain = 0.97;       // greatest relative length of a tried way through a gap
constexpr int kTrialEvaluations = 6;    // evaluations of a way on the other side
constexpr std::size_t kTrialBends = 2;  // number of bends whose other side is tried
constexpr int kMovingTrials = 4;        // the same among moving discs, where plans are short-lived
constexpr std::size_t kMovingBends = 1;
constexpr double kPassing = 1.2;                    // [m/s] through a goal with a wanted heading
constexpr double kTightPass = 0.015;                // [m] of clearance; with less, lower speeds are tried
constexpr std::array<double, 2> kSlower{0.5, 0.4};  // relative to the best plan's top speed

}  // namespace

void SplinePlanner::plan(const NavigationScene& scene, std::span<const ForecastDisc> discs, bool any_moves,
                         bool turn_at_goal) {
  any_moves_ = any_moves;
  wants_heading_ = scene.goal.heading.has_value();
  spent_ = 0;
  best_ = {};
  setTask(scene, discs);
  if (!scene.goal.heading) {
    choose(scene, Arrival::kFree);
  } else {
    if (!turn_at_goal && !scene.goal.stop) choose(scene, Arrival::kThrough);
    choose(scene, Arrival::kTurn);
  }
  if (any_moves_ && best_.score().clearance < kTightPass) trySlower();
}

bool SplinePlanner::turnsSharply() const {
  if (!request_.start_direction || spline().controls() <= 2) return false;
  const Vec2 first = unitOr(spline().control(2) - spline().control(1), *request_.start_direction);
  return dot(first, *request_.start_direction) < kSharpTurn;
}

bool SplinePlanner::improve(bool any_moves, std::size_t first_free) {
  const int effort = any_moves ? params_.moving_effort : params_.effort;
  if (spent_ >= effort || best_.converged()) return false;
  best_.freezeBefore(first_free);
  cost_.setTask(best_task_);
  const double before = best_.score().cost;
  const int used = best_.improve(cost_, std::min(params_.evaluations, effort - spent_));
  spent_ = used > 0 ? spent_ + used : effort;
  return best_.score().cost < before;
}

void SplinePlanner::setTask(const NavigationScene& scene, std::span<const ForecastDisc> discs) {
  const double speed = norm(scene.self.velocity);
  const Vec2 facing = math::unit(scene.self.pose.heading);
  const bool moving = speed > kAtRest && dot(scene.self.velocity, facing) > 0.0;
  task_.limits = speedLimits(*scene.robot, params_.acceleration_share, params_.lateral_share);
  task_.limits.start_speed = moving ? speed : 0.0;
  task_.body = bodyShape(*scene.robot);
  task_.clearance_wish = params_.clearance;
  task_.clearance_least = params_.least_clearance;
  task_.field = scene.field;
  task_.discs = discs;
  task_.start_direction = moving ? std::nullopt : std::optional(facing);

  request_ = {};
  request_.start = scene.self.pose.position;
  if (moving) request_.start_direction = scene.self.velocity / speed;
  request_.goal = scene.goal.position;
  request_.speed = kMeanSpeed * scene.robot->maxSpeed();
}

void SplinePlanner::choose(const NavigationScene& scene, Arrival arrival) {
  SeedRequest wanted = request_;
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
      seeder_.search(wanted, *scene.robot, *scene.field, task_.discs, SplineSeeder::Room::kTurning);
  const double length = found ? seeder_.length() : kInfinity;
  if (found) tryWays();
  if (found && seeder_.bends() == 0) return;
  // A narrow gap, which needs a straight pass, is tried where the way round is long.
  if (seeder_.search(wanted, *scene.robot, *scene.field, task_.discs, SplineSeeder::Room::kStraight)
          ? seeder_.length() < kGapGain * length
          : !found) {
    tryWays();
  }
}

void SplinePlanner::tryWays() {
  tryCandidate(seeder_.shortest());
  CubicSpline other;
  const std::size_t bends = std::min(seeder_.bends(), any_moves_ ? kMovingBends : kTrialBends);
  for (std::size_t bend = 0; bend < bends; ++bend) {
    if (seeder_.otherSide(bend, kDetour, other)) tryCandidate(other);
  }
}

void SplinePlanner::tryCandidate(const CubicSpline& seed) {
  const bool through = wants_heading_ && task_.limits.end_speed > 0.0;
  candidate_.start(seed, task_.start_direction ? 1 : 2, through ? 2 : 1, kFirstStep);
  int trials = candidate_.improve(cost_, 1);
  // Trials cannot improve a straight way with full clearance.
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

void SplinePlanner::trySlower() {
  const CubicSpline way = best_.best();
  task_ = best_task_;
  for (const double share : kSlower) {
    task_.limits.max_speed = share * best_task_.limits.max_speed;
    cost_.setTask(task_);
    tryCandidate(way);
    if (best_.score().clearance >= kTightPass) break;
  }
}

}  // namespace fulbito
