#include "match/drills/ideal.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/math.hpp"
#include "engine/sim/world.hpp"

namespace fulbito {
namespace {

constexpr double kLongest = 5.0;  // [s] after which an interception is given up

/// Whether one of the tested team's robots can be at the ball by then.
bool meets(const DrillScene& scene, const RobotPreset& robot, Vec2 ball, double time) {
  const double reach = robot.robot.length / 2 + robot.ball.radius;
  const auto& own = scene.placement.robots[indexOf(TeamId::kBlue)];
  return std::any_of(own.begin(), own.end(), [&](const std::optional<Pose2>& pose) {
    if (!pose) return false;
    const Vec2 way = ball - pose->position;
    const double bearing = math::wrapAngle(math::angleOf(way) - pose->heading);
    return timeToReach(robot.robot, std::max(0.0, norm(way) - reach), bearing) <= time;
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

bool isRace(const Drill& drill) {
  return std::any_of(drill.successes.begin(), drill.successes.end(),
                     [](const DrillEnd& end) { return end.what == DrillCondition::kTouched; });
}

}  // namespace

double timeToReach(const RobotModel& robot, double distance, double bearing) {
  const double folded = std::min(std::abs(bearing), math::kPi - std::abs(bearing));
  const double a = robot.wheel_acceleration;
  const double v = robot.maxSpeed();
  const double turn = 1.4 * std::sqrt(folded / robot.turnAcceleration());
  return turn + (distance < v * v / (2.0 * a) ? std::sqrt(2.0 * distance / a) : distance / v + v / (2.0 * a));
}

double timeToTurn(const RobotModel& robot, double angle) {
  return 2.0 * std::sqrt(std::abs(angle) / robot.turnAcceleration());
}

double idealTime(const Drill& drill, const DrillScene& scene, const MatchConfig& config) {
  const DrillTask task = drill.starts[static_cast<std::size_t>(scene.start)].task;
  if (task == DrillTask::kPlay) return isRace(drill) ? timeToMeet(scene, config) : 0.0;
  const auto& pose = scene.placement.robots[indexOf(TeamId::kBlue)][0];
  if (!pose) return 0.0;
  const double turn = math::wrapAngle(scene.exercise.heading - pose->heading);
  if (task == DrillTask::kReachPose) {
    return timeToReach(config.robot.robot, distance(scene.exercise.target, pose->position), turn);
  }
  return task == DrillTask::kTurn ? timeToTurn(config.robot.robot, turn) : 0.0;
}

}  // namespace fulbito
