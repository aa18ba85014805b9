#include "match/drills/ideal.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "fulbito/world.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito {
namespace {

constexpr double kLongest = 5.0;  // [s] limit of the search for an interception

/// Angle [rad] that a robot turns if either end may lead.
double folded(double bearing) { return std::min(std::abs(bearing), math::kPi - std::abs(bearing)); }

/// Whether one of the tested team's robots can be at the ball at this time.
bool meets(const DrillScene& scene, const RobotPreset& robot, Vec2 ball, double time) {
  const double reach = robot.robot.length / 2 + robot.ball.radius;
  const RobotPace pace(robot.robot);
  const auto& own = scene.placement.robots[indexOf(TeamId::kBlue)];
  return std::any_of(own.begin(), own.end(), [&](const std::optional<Pose2>& pose) {
    if (!pose) return false;
    const Vec2 way = ball - pose->position;
    const double bearing = math::wrapAngle(math::angleOf(way) - pose->heading);
    return timeToReach(pace, std::max(0.0, norm(way) - reach), folded(bearing)) <= time;
  });
}

/// The first time at which a robot can be at the ball, which rolls on a field without robots.
double timeToMeet(const DrillScene& scene, const MatchConfig& config) {
  WorldConfig alone;
  alone.field = config.field;
  alone.physics = config.physics;
  const Vec2 velocity = scene.placement.ball_velocity;
  alone.balls.push_back({config.robot.ball, scene.placement.ball, velocity, velocity});
  auto world = World::create(alone);
  if (!world) return 0.0;
  double time = 0.0;
  while (time < kLongest && !meets(scene, config.robot, world->state().balls.front().position, time)) {
    world->step({});
    time = static_cast<double>(world->state().tick) * config.physics.controlPeriod();
  }
  return time;
}

/// The least time in which one of the tested team's robots carries a resting ball into the opponents' goal:
/// it drives to the place behind the ball, and on from there without a stop. 0 without robots.
double timeToScore(const DrillScene& scene, const MatchConfig& config) {
  const RobotModel& robot = config.robot.robot;
  const RobotPace pace(robot);
  const Vec2 ball = scene.placement.ball, goal{config.field.length / 2, 0.0};
  const Vec2 way = goal - ball;
  const Vec2 behind = ball - unitOr(way, {1.0, 0.0}) * (robot.length / 2 + config.robot.ball.radius);
  std::optional<double> least;
  for (const std::optional<Pose2>& pose : scene.placement.robots[indexOf(TeamId::kBlue)]) {
    if (!pose) continue;
    const Vec2 to = behind - pose->position;
    const double bearing = math::wrapAngle(math::angleOf(to) - pose->heading);
    const double arrives = std::min(pace.speed, std::sqrt(2.0 * pace.acceleration * norm(to)));
    const double time = timeToReach(pace, norm(to), folded(bearing)) + timeAlong(pace, norm(way), arrives);
    least = std::min(least.value_or(time), time);
  }
  return least.value_or(0.0);
}

/// Whether what is asked for in play is a touch, a goal and so on.
bool asksFor(const Drill& drill, const DrillStart& start, DrillCondition what) {
  return std::any_of(drill.successes.begin(), drill.successes.end(), [&](const DrillEnd& end) {
    return end.what == what && (end.start.empty() || end.start == start.name);
  });
}

}  // namespace

bool hasLeastTime(const Drill& drill, const DrillStart& start) {
  if (start.task != DrillTask::kPlay)
    return start.task == DrillTask::kReachPose || start.task == DrillTask::kTurn;
  return asksFor(drill, start, DrillCondition::kTouched) ||
         (asksFor(drill, start, DrillCondition::kGoal) && start.speed_max == 0.0);
}

double idealTime(const Drill& drill, const DrillScene& scene, const MatchConfig& config) {
  const DrillStart& start = drill.starts[static_cast<std::size_t>(scene.start)];
  const DrillTask task = start.task;
  if (!hasLeastTime(drill, start)) return 0.0;
  if (task == DrillTask::kPlay) {
    const bool race = asksFor(drill, start, DrillCondition::kTouched);
    return race ? timeToMeet(scene, config) : timeToScore(scene, config);
  }
  const auto& pose = scene.placement.robots[indexOf(TeamId::kBlue)][0];
  if (!pose) return 0.0;
  const double turn = math::wrapAngle(scene.exercise.heading - pose->heading);
  const RobotPace pace(config.robot.robot);
  if (task == DrillTask::kReachPose) {
    return timeToReach(pace, distance(scene.exercise.target, pose->position), folded(turn));
  }
  return timeToTurn(pace, std::abs(turn));
}

}  // namespace fulbito
