#include "match/drills/opponents.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kTurnGain = 10.0;     // [1/s] yaw rate per heading error
constexpr double kApproachGain = 8.0;  // [1/s] speed per distance left
// [s] for which a team must have seen the ball before its answer counts
constexpr double kSettled = 0.2;
constexpr double kKeeperLine = 0.055;  // [m] the keeper's centre before the goal line
constexpr double kKeeperReach = 0.16;  // [m] largest distance of the keeper's centre from the long axis
constexpr double kBehind = 0.09;       // [m] robot's centre behind the ball when it begins to push
constexpr double kAlong = 0.03;        // [m] sideways error at which a presser pushes

/// Drives straight at a point with whichever end is nearer.
Twist driveAt(const RobotState& robot, Vec2 target, double top_speed, bool stop) {
  const Vec2 way = target - robot.pose.position;
  double error = math::wrapAngle(math::angleOf(way) - robot.pose.heading);
  const bool backward = std::abs(error) > math::kPi / 2;
  if (backward) error = math::wrapAngle(error + math::kPi);
  double speed = top_speed * std::max(0.0, math::cos(error));
  if (stop) speed = std::min(speed, kApproachGain * norm(way));
  return {backward ? -speed : speed, kTurnGain * error};
}

/// Drives parallel to the goal line to the point that leaves equal gaps on both sides.
Twist keep(const MatchInfo& info, const RobotState& robot, Vec2 ball) {
  Vec2 place = equalGapPoint(info.field, ball, kKeeperLine);
  place.y = std::clamp(place.y, -kKeeperReach, kKeeperReach);
  const Vec2 off = place - robot.pose.position;
  if (std::abs(off.x) > 0.03) return driveAt(robot, place, info.robot.maxSpeed(), true);
  const double facing = robot.pose.heading < 0.0 ? -math::kPi / 2 : math::kPi / 2;
  const double forward = facing < 0.0 ? -off.y : off.y;
  const double speed =
      std::clamp(2.0 * kApproachGain * forward, -info.robot.maxSpeed(), info.robot.maxSpeed());
  return {speed, kTurnGain * math::wrapAngle(facing - robot.pose.heading)};
}

/// Drives round the ball, then through it toward the opponents' goal.
Twist press(const MatchInfo& info, const RobotState& robot, Vec2 ball) {
  const Vec2 goal{info.field.length / 2, 0.0};
  const Vec2 along = math::unit(math::angleOf(goal - ball));
  const Vec2 from_ball = robot.pose.position - ball;
  const double behind = -dot(from_ball, along);
  const double aside = along.x * from_ball.y - along.y * from_ball.x;
  if (behind > 0.0 && std::abs(aside) < kAlong) return driveAt(robot, ball, info.robot.maxSpeed(), false);
  Vec2 target = ball - along * kBehind;
  if (behind < 0.0) target += Vec2{-along.y, along.x} * std::copysign(kBehind, aside);
  return driveAt(robot, target, info.robot.maxSpeed(), false);
}

class Scripted final : public Strategy {
 public:
  explicit Scripted(const std::array<DrillRole, kMaxTeamSize>& roles) : roles_(roles) {}
  void begin(const MatchInfo& info) override { info_ = info; }

  TeamCommand decide(const Observation& observation) override {
    TeamCommand command;
    for (std::size_t i = 0; i < roles_.size(); ++i) {
      if (!observation.own[i].present) continue;
      command.robots[i] =
          RobotCommand::byTwist(move(roles_[i], observation.own[i].state, observation.ball.position));
    }
    return command;
  }

 private:
  Twist move(DrillRole role, const RobotState& robot, Vec2 ball) const {
    switch (role) {
      case DrillRole::kChase:
        return driveAt(robot, ball, info_.robot.maxSpeed(), false);
      case DrillRole::kKeep:
        return keep(info_, robot, ball);
      case DrillRole::kPress:
        return press(info_, robot, ball);
      default:
        return {};
    }
  }

  std::array<DrillRole, kMaxTeamSize> roles_;
  MatchInfo info_;
};

class Exercised final : public Strategy {
 public:
  Exercised(std::unique_ptr<Strategy> team, bool outside, const Exercise& exercise, ExerciseLog& log)
      : team_(std::move(team)), outside_(outside), exercise_(exercise), log_(&log) {}
  void begin(const MatchInfo& info) override { team_->begin(info); }
  std::span<const NavigatorChoice> navigators() const override { return team_->navigators(); }
  void allow(double seconds) override { team_->allow(seconds); }
  /// A team outside the program would take this as the request for a decision.
  void ask(const Observation& observation) override {
    if (!outside_) team_->ask(observation);
  }
  const TeamCondition& condition() const override { return team_->condition(); }
  void stopped(const PlayStop& stop) override { team_->stopped(stop); }
  void ready(const Observation& observation) override { team_->ready(observation); }
  void ended(const MatchEnd& end) override { team_->ended(end); }

  TeamCommand decide(const Observation& observation) override {
    auto reply = team_->exercise(observation, exercise_);
    if (!reply) {
      log_->offered = false;
      return {};
    }
    if (log_->asked < 0 && observation.since_restart >= kSettled - observation.dt / 2) {
      log_->asked = observation.tick;
      log_->answer = reply->answer;
    }
    return std::move(reply->command);
  }

 private:
  std::unique_ptr<Strategy> team_;
  bool outside_;
  Exercise exercise_;
  ExerciseLog* log_;
};

}  // namespace

TeamChoice scriptedTeam(const std::array<DrillRole, kMaxTeamSize>& roles) {
  return TeamChoice::own("scripted", [roles] { return std::make_unique<Scripted>(roles); });
}

TeamChoice exercisedTeam(const TeamChoice& team, const Exercise& exercise, ExerciseLog& log) {
  TeamInfo info;
  info.name = team.info->name;
  info.outside = team.info->outside;
  info.make = [team, exercise, &log](const std::vector<Setting>&) -> Result<std::unique_ptr<Strategy>> {
    auto made = makeTeam(team);
    if (!made) return tl::unexpected<Error>(made.error());
    return std::unique_ptr<Strategy>(
        std::make_unique<Exercised>(std::move(*made), team.info->outside, exercise, log));
  };
  return {std::make_shared<const TeamInfo>(std::move(info)), team.text, {}, {}};
}

}  // namespace fulbito
