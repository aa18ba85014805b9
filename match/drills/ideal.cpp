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

bool isRace(const Drill& drill) {
  return std::any_of(drill.successes.begin(), drill.successes.end(),
                     [](const DrillEnd& end) { return end.what == DrillCondition::kTouched; });
}

}  // namespace

double idealTime(const Drill& drill, const DrillScene& scene, const MatchConfig& config) {
  const DrillTask task = drill.starts[static_cast<std::size_t>(scene.start)].task;
  if (task == DrillTask::kPlay) return isRace(drill) ? timeToMeet(scene, config) : 0.0;
  const auto& pose = scene.placement.robots[indexOf(TeamId::kBlue)][0];
  if (!pose) return 0.0;
  const double turn = math::wrapAngle(scene.exercise.heading - pose->heading);
  const RobotPace pace(config.robot.robot);
  if (task == DrillTask::kReachPose) {
    return timeToReach(pace, distance(scene.exercise.target, pose->position), folded(turn));
  }
  return task == DrillTask::kTurn ? timeToTurn(pace, std::abs(turn)) : 0.0;
}

}  // namespace fulbito
