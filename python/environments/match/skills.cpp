#include "python/environments/match/skills.hpp"

#include <array>

#include "fulbito/detail/math.hpp"
#include "strategies/skills/ball_posture.hpp"
#include "strategies/skills/interception.hpp"
#include "strategies/skills/line_keeping.hpp"
#include "strategies/skills/positions.hpp"
#include "strategies/skills/receiving.hpp"
#include "strategies/skills/shot_geometry.hpp"
#include "strategies/skills/wall_play.hpp"

namespace fulbito {
namespace {

constexpr double kStrikeSpeed = 1.0;   // [m/s]
constexpr double kShadowGap = 0.2;     // [m] from the ball
constexpr double kKeeperDepth = 0.06;  // [m] of its line in front of the goal line
constexpr double kBackSpeed = 0.5;     // [m/s]

RobotCommand driveTo(Vec2 place, bool stop) {
  GoTo go_to;
  go_to.position = place;
  go_to.stop = stop;
  return RobotCommand::drivingTo(go_to);
}

}  // namespace

std::vector<std::string> skillNames() {
  return {"stay", "strike", "clear", "intercept", "receive", "keep", "shadow", "rebound", "spin", "back-off"};
}

void RobotSkills::begin(const MatchInfo& info) {
  info_ = info;
  course_ = BallCourse(info.field, info.ball, info.physics);
  pace_ = RobotPace(info.robot);
  round_ = lined_up_ = false;
}

Vec2 RobotSkills::shotTarget(const Observation& seen) const {
  std::array<ShotBlocker, kMaxTeamSize> blockers;
  std::size_t count = 0;
  for (const ObservedRobot& other : seen.opponents) {
    if (!other.present) continue;
    blockers[count++] = {other.state.pose.position, info_.robot.width / 2, other.state.velocity};
  }
  const auto shot = bestShot(info_.field, {}, seen.ball.position, {blockers.data(), count});
  return shot.value_or(opponentGoal(info_.field));
}

RobotCommand RobotSkills::strikeToward(Vec2 target, const Observation& seen, const RobotState& robot) {
  const Vec2 ball = seen.ball.position;
  const double away = distance(target, ball);
  const Vec2 direction = away > 0.0 ? (target - ball) / away : Vec2{1.0, 0.0};
  lined_up_ = isLinedUp(sideOfBall(robot, ball, direction), lined_up_);
  const BallApproach approach = approachBall(robot, ball, direction, round_);
  round_ = approach.round;
  if (lined_up_) return RobotCommand::byTwist(strike(robot, ball, direction, kStrikeSpeed));
  return RobotCommand::drivingTo(approach.go_to);
}

RobotCommand RobotSkills::keep(const RobotState& robot) {
  const Vec2 place = keeperPoint(info_.field, ball_, kKeeperDepth, info_.field.goal_width / 2);
  if (const auto twist = keepLine(robot, place, info_.robot.maxSpeed())) return RobotCommand::byTwist(*twist);
  return driveTo(place, true);
}

RobotCommand RobotSkills::play(Skill skill, const Observation& seen, std::size_t number) {
  const RobotState& robot = seen.own[number].state;
  BallState ball = seen.ball;
  ball.spin = ball.velocity;  // observations have no spin: the ball rolls
  ball_.predict(course_, ball);
  switch (skill) {
    case Skill::kStrike:
      return strikeToward(shotTarget(seen), seen, robot);
    case Skill::kClear: {
      std::array<Vec2, kMaxTeamSize> others;
      std::size_t count = 0;
      for (const ObservedRobot& other : seen.opponents) {
        if (other.present) others[count++] = other.state.pose.position;
      }
      return strikeToward(clearanceTarget(info_.field, ball.position, {others.data(), count}), seen, robot);
    }
    case Skill::kIntercept: {
      const auto meeting = intercept(ball_, pace_, robot);
      return driveTo(meeting ? meeting->robot : ball.position, false);
    }
    case Skill::kReceive:
      return RobotCommand::byTwist(receive(robot, seen.ball, pace_));
    case Skill::kKeep:
      return keep(robot);
    case Skill::kShadow:
      return driveTo(shadowPoint(info_.field, ball.position, kShadowGap), true);
    case Skill::kRebound:
      return driveTo(reboundSpot(info_.field, ball.position), true);
    case Skill::kSpin: {
      const Vec2 wanted = opponentGoal(info_.field) - ball.position;
      const double sense = spinSense(robot.pose.position, ball.position, wanted);
      const double fastest = 2.0 * info_.robot.maxSpeed() / info_.robot.axle_track;
      return RobotCommand::byWheels(inverseKinematics(info_.robot, {0.0, sense * fastest}));
    }
    case Skill::kBackOff:
      return RobotCommand::byTwist({-kBackSpeed, 0.0});
    case Skill::kStay:
      break;
  }
  return RobotCommand::byWheels({});
}

}  // namespace fulbito
