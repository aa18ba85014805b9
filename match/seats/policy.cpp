#include "match/seats/policy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace fulbito {
namespace {

// [m] by which a place may lie beyond the field, as a robot drives through a ball at a wall
constexpr double kBeyondField = 0.5;
constexpr double kLeastTolerance = 1e-4;  // [m]

bool finite(const GoTo& go_to) {
  return isFinite(go_to.position) && (!go_to.heading || std::isfinite(*go_to.heading)) &&
         std::isfinite(go_to.tolerance) && !std::isnan(go_to.speed_limit);
}

bool finite(const RobotCommand& command) {
  switch (command.kind) {
    case RobotCommand::Kind::kWheels:
      return std::isfinite(command.wheels.left) && std::isfinite(command.wheels.right);
    case RobotCommand::Kind::kTwist:
      return std::isfinite(command.twist.linear) && std::isfinite(command.twist.angular);
    case RobotCommand::Kind::kGoTo:
      return finite(command.go_to);
  }
  return false;  // a team in another process may send any value
}

bool powerOfTen(std::int64_t n) {
  while (n >= 10 && n % 10 == 0) n /= 10;
  return n == 1;
}

}  // namespace

CommandPolicy::CommandPolicy(TeamId team, const MatchInfo& info, std::size_t navigators)
    : team_(team),
      robot_(info.robot),
      reach_{info.field.length / 2 + info.field.goal_depth + kBeyondField,
             info.field.width / 2 + kBeyondField},
      command_step_(info.physics.wheel_command_step),
      team_size_(static_cast<std::size_t>(info.rules.team_size)),
      navigators_(navigators),
      held_most_(info.decision_time ? info.decision_time->held : 0) {}

void CommandPolicy::reset() {
  command_ = TeamCommand{};
  held_ = 0;
}

void CommandPolicy::note(std::int64_t& count, const char* clause, const GameEvent& now,
                         std::vector<GameEvent>& events) {
  if (!powerOfTen(++count)) return;
  GameEvent event = now;
  event.clause = clause;
  event.law = "policy";
  event.team = team_;
  event.value = static_cast<double>(count);
  events.push_back(event);
}

void CommandPolicy::take(TeamCommand&& decision, bool late, bool stands, const GameEvent& now,
                         std::vector<GameEvent>& events) {
  if (late) note(faults_.late, "command.late", now, events);
  if (late && !stands) {
    if (++held_ > held_most_) command_ = TeamCommand{};
    return;
  }
  held_ = 0;
  command_ = std::move(decision);
  for (std::size_t i = 0; i < team_size_; ++i) clean(i, now, events);
}

void CommandPolicy::count(const TeamCondition& condition, const GameEvent& now,
                          std::vector<GameEvent>& events) {
  faults_.stale = condition.stale;
  if (condition.failures == faults_.failures) return;
  faults_.failures = condition.failures;
  faults_.failure = condition.reason;
  faults_.forfeited = condition.state == TeamCondition::State::kLost;
  GameEvent event = now;
  event.clause = "team.failed";
  event.law = "policy";
  event.team = team_;
  event.value = condition.failures;
  events.push_back(event);
}

void CommandPolicy::clean(std::size_t number, const GameEvent& now, std::vector<GameEvent>& events) {
  RobotCommand& command = command_.robots[number];
  GameEvent event = now;
  event.robot = static_cast<std::uint8_t>(number);
  if (!finite(command)) {
    note(faults_.not_finite, "command.not-finite", event, events);
    command = RobotCommand{};
  } else if (command.kind == RobotCommand::Kind::kGoTo) {
    if (command.go_to.navigator < navigators_) {
      keepOnField(command.go_to);
    } else {
      note(faults_.no_navigator, "command.no-navigator", event, events);
      command = RobotCommand{};
    }
  }
}

void CommandPolicy::keepOnField(GoTo& go_to) {
  const Vec2 kept{std::clamp(go_to.position.x, -reach_.x, reach_.x),
                  std::clamp(go_to.position.y, -reach_.y, reach_.y)};
  if (!(kept == go_to.position)) ++faults_.saturated;
  go_to.position = kept;
  go_to.tolerance = std::max(go_to.tolerance, kLeastTolerance);
}

WheelSpeeds CommandPolicy::actuated(WheelSpeeds wanted) {
  const WheelSpeeds cut = saturate(robot_, wanted);
  if (cut.left != wanted.left || cut.right != wanted.right) ++faults_.saturated;
  return roundedTo(cut, command_step_);
}

}  // namespace fulbito
