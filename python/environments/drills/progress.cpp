#include "python/environments/drills/progress.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito {
namespace {

constexpr double kRunUp = 0.25;        // [m] farthest place behind a ball from which a robot drives at it
constexpr double kSlope = 2.0;         // of the lane behind the ball: distance from it per error to the side
constexpr double kKeeperLine = 0.055;  // [m] from the goal line to a keeper's centre

/// The true world in the frame of the tested team.
struct Truth {
  Vec2 ball;
  Vec2 ball_start;
  Pose2 robot;
};

Truth truthOf(const DrillTrialRun& trial, int number) {
  const Match& match = trial.match();
  const TeamId seat = trial.scene().seat;
  const Side side = match.referee().sideOf(seat);
  const auto robot = RobotId{seat, static_cast<std::uint8_t>(number)};
  Truth truth;
  truth.ball_start = trial.watch().ballStart();
  truth.ball = inTeamFrame(side, match.world().balls.front().position);
  const auto ids = match.ids();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    if (ids[i] == robot) truth.robot = inTeamFrame(side, match.world().robots[i].pose);
  }
  return truth;
}

/// Where a robot shall be that sends the ball along `heading`: on a lane behind the ball that leads to it. A
/// robot that is off the lane begins farther back.
Vec2 behindBall(const Truth& truth, double heading, double touch) {
  const Vec2 from_ball = intoFrame(math::unit(heading), truth.robot.position - truth.ball);
  const double back = from_ball.x > 0.0 ? kRunUp : std::clamp(kSlope * std::abs(from_ball.y), touch, kRunUp);
  return truth.ball - math::unit(heading) * back;
}

double sharePast(const DrillEnd& end, const Truth& truth, const FieldGeometry& field) {
  const Vec2 mouth{field.length / 2, std::clamp(truth.ball.y, -field.goal_width / 2, field.goal_width / 2)};
  const double beyond_area = std::max(truth.ball.x + field.length / 2 - field.goal_area_depth,
                                      std::abs(truth.ball.y) - field.goal_area_width / 2);
  const double value = std::max(end.value, 1e-3);
  switch (end.what) {
    case DrillCondition::kGoal:
      return truth.ball.x > field.length / 2 ? 1.0 : 1.0 - distance(truth.ball, mouth) / field.length;
    case DrillCondition::kNearMouth:
      return 1.0 - std::max(0.0, distance(truth.ball, mouth) - end.value) / field.length;
    case DrillCondition::kGained:
      return (truth.ball.x - truth.ball_start.x) / value;
    case DrillCondition::kDriven:
      return (truth.ball_start.x - truth.ball.x) / value;
    case DrillCondition::kOffWall:
      return wallClearance(field, truth.ball) / value;
    case DrillCondition::kAway:
      return distance(truth.ball, truth.ball_start) / value;
    case DrillCondition::kCleared:
      return 1.0 + std::min(0.0, beyond_area - end.value) / field.goal_area_depth;
    default:
      return 0.0;
  }
}

/// The best share of the conditions of success; 0 if none is about a place of the ball.
double ballShare(const DrillTrialRun& trial, const Truth& truth, const FieldGeometry& field) {
  double best = -std::numeric_limits<double>::infinity();
  for (const DrillEnd& end : trial.drill().successes) {
    if (!end.start.empty() && end.start != trial.start().name) continue;
    best = std::max(best, std::clamp(sharePast(end, truth, field), -1.0, 1.0));
  }
  return std::isfinite(best) ? best : 0.0;
}

bool succeedsBy(const DrillTrialRun& trial, std::initializer_list<DrillCondition> conditions) {
  const auto& ends = trial.drill().successes;
  return std::any_of(ends.begin(), ends.end(), [&](const DrillEnd& end) {
    const bool here = end.start.empty() || end.start == trial.start().name;
    return here && std::find(conditions.begin(), conditions.end(), end.what) != conditions.end();
  });
}

/// Where the drill needs the robot in play.
Vec2 placeInPlay(const DrillTrialRun& trial, const Truth& truth, double touch) {
  const FieldGeometry& field = trial.match().config().field;
  if (succeedsBy(trial, {DrillCondition::kLasted})) {
    return equalGapPoint(field, truth.ball, kKeeperLine);
  }
  if (!succeedsBy(trial, {DrillCondition::kGoal, DrillCondition::kNearMouth, DrillCondition::kGained})) {
    return truth.ball;
  }
  return behindBall(truth, math::angleOf(Vec2{field.length / 2, 0.0} - truth.ball), touch);
}

/// Minus the error of the heading, as a share of a half turn.
double alignment(double heading, double wanted, bool either_end) {
  double error = std::abs(math::wrapAngle(heading - wanted));
  if (either_end) error = std::min(error, math::kPi - error);
  return -error / math::kPi;
}

}  // namespace

DrillProgressNow drillProgress(const DrillTrialRun& trial, int robot, const RobotPreset& preset) {
  const Truth truth = truthOf(trial, robot);
  const FieldGeometry& field = trial.match().config().field;
  const Exercise& task = trial.scene().exercise;
  const double touch = preset.robot.length / 2 + preset.ball.radius;
  const auto from = [&](Vec2 place) {
    return -distance(truth.robot.position, insideWalls(field, place, preset.robot.length / 2));
  };
  switch (trial.start().task) {
    case DrillTask::kPlay:
      return {ballShare(trial, truth, field), from(placeInPlay(trial, truth, touch)), 0.0};
    case DrillTask::kReachPose:
      return {0.0, from(task.target), alignment(truth.robot.heading, task.heading, true)};
    case DrillTask::kTurn:
      return {0.0, 0.0, alignment(truth.robot.heading, task.heading, false)};
    case DrillTask::kReachBall:
      return {0.0, from(behindBall(truth, task.heading, touch)),
              alignment(truth.robot.heading, task.heading, true)};
    case DrillTask::kPush: {
      const Vec2 moved = intoFrame(math::unit(task.heading), truth.ball - truth.ball_start);
      const double way = std::max(distance(task.target, truth.ball_start), 1e-3);
      return {std::clamp((moved.x - std::abs(moved.y)) / way, -1.0, 1.0), from(truth.ball),
              alignment(truth.robot.heading, task.heading, true)};
    }
    case DrillTask::kPredictBall:
      return {};
  }
  return {};
}

}  // namespace fulbito
