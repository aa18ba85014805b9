#include "bridge/abi/team_values.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "navigation/library/plugin_values.hpp"

namespace fulbito {
namespace {

// Those below would hide them.
using fulbito::fromAbi;
using fulbito::toAbi;

fulbito_ball_model toAbi(const BallModel& ball) {
  return {ball.radius,
          ball.mass,
          ball.roll_keep,
          ball.slide_deceleration,
          ball.roll_deceleration,
          ball.stop_speed,
          ball.wall_restitution,
          ball.wall_spin_keep,
          ball.robot_restitution,
          ball.friction};
}

fulbito_physics toAbi(const PhysicsProfile& physics) {
  fulbito_physics to{};
  copyName(physics.name, to.name);
  to.control_rate = physics.control_rate;
  to.substeps = physics.substeps;
  to.velocity_iterations = physics.velocity_iterations;
  to.position_iterations = physics.position_iterations;
  to.bullet_ball = physics.bullet_ball;
  to.contact_depth = physics.contact_depth;
  to.max_ball_speed = physics.max_ball_speed;
  to.restitution_threshold = physics.restitution_threshold;
  to.wheel_command_step = physics.wheel_command_step;
  return to;
}

/// Largest number of robots in an area; -1: any number.
int32_t limitOf(bool enabled, int most) { return enabled ? most : -1; }

void areasToAbi(const AreaRules& areas, fulbito_rules& to) {
  to.areas_have_arc = areas.arc;
  to.attackers_max = limitOf(areas.attackers, areas.attackers_max);
  to.big_attackers_max = limitOf(areas.attackers, areas.big_attackers_max);
  to.defenders_max = limitOf(areas.defenders, areas.defenders_max);
  to.big_defenders_max = limitOf(areas.defenders, areas.big_defenders_max);
}

void foulsToAbi(const Rules& rules, fulbito_rules& to) {
  to.keeper_hold_seconds = rules.keeper.holding ? rules.keeper.hold_seconds : 0.0;
  to.keeper_charging = rules.keeper.charged;
  to.pushing = rules.fouls.push;
  to.pinning = rules.fouls.holding;
  to.pinned_seconds = rules.fouls.pinned_seconds;
}

void periodsToAbi(const Rules& rules, fulbito_rules& to) {
  to.half_seconds = rules.half_seconds;
  to.swap_sides = rules.periods.swap_sides;
  to.mercy_goals = rules.periods.mercy_goals;
  to.tie_break = static_cast<int32_t>(rules.periods.tie_break);
  to.overtime_parts = rules.periods.overtime_parts;
  to.overtime_seconds = rules.periods.overtime_seconds;
  to.golden_goal = rules.periods.golden_goal;
  to.kick_seconds = rules.shoot_out.kick_seconds;
}

void restartsToAbi(const Rules& rules, fulbito_rules& to) {
  to.restart_delay = rules.restart.delay;
  to.goal_delay = rules.restart.goal_delay;
  to.hold_robots = rules.restart.hold_robots;
  to.false_start_distance = rules.restart.false_start_distance;
  to.free_ball_distance = rules.free_ball.distance;
  to.goal_kick_ball_free = rules.goal_kick.ball_free;
  to.stuck_seconds = rules.stuck.seconds;
  to.stuck_area_seconds = rules.stuck.area_seconds;
  to.stuck_radius = rules.stuck.radius;
}

fulbito_rules toAbi(const Rules& rules) {
  fulbito_rules to{};
  copyName(rules.name, to.name);
  to.team_size = rules.team_size;
  periodsToAbi(rules, to);
  restartsToAbi(rules, to);
  areasToAbi(rules.areas, to);
  foulsToAbi(rules, to);
  return to;
}

void robotsToAbi(const std::array<ObservedRobot, kMaxTeamSize>& robots, int team_size,
                 fulbito_robot (&to)[FULBITO_MAX_ROBOTS]) {
  for (int i = 0; i < team_size; ++i) {
    const ObservedRobot& robot = robots[static_cast<std::size_t>(i)];
    to[i] = robot.present ? toAbi(robot.state) : fulbito_robot{};
  }
}

template <typename P>
fulbito_poses posesToAbi(const P& poses) {
  fulbito_poses to{};
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (!poses[i]) continue;
    to.present[i] = 1;
    to.pose[i] = toAbi(*poses[i]);
  }
  return to;
}

GoTo fromAbi(const fulbito_go_to& from) {
  GoTo to;
  to.position = fromAbi(from.position);
  if (from.has_heading != 0) to.heading = from.heading;
  to.stop = from.stop != 0;
  to.speed_limit = from.speed_limit;
  to.avoid_ball = from.avoid_ball != 0;
  to.avoid_mates = from.avoid_mates != 0;
  to.avoid_opponents = from.avoid_opponents != 0;
  to.tolerance = from.tolerance;
  to.either_front = from.either_front != 0;
  to.navigator = from.navigator;
  return to;
}

/// A kind that the interface lacks stays one that the simulator lacks: its policy counts it as a fault.
RobotCommand fromAbi(const fulbito_robot_command& from) {
  constexpr std::uint32_t kUnknown = 255;
  RobotCommand to;
  to.kind = static_cast<RobotCommand::Kind>(from.kind <= FULBITO_BY_GO_TO ? from.kind : kUnknown);
  to.wheels = fromAbi(from.wheels);
  to.twist = fromAbi(from.twist);
  to.go_to = fromAbi(from.go_to);
  return to;
}

void fromAbi(const fulbito_drawing& from, DebugDrawing& to) {
  to.kind = static_cast<DebugDrawing::Kind>(from.kind);
  to.from = fromAbi(from.from);
  to.to = fromAbi(from.to);
  to.radius = from.radius;
  to.text.assign(from.text, strnlen(from.text, sizeof from.text));
}

}  // namespace

fulbito_match_info toAbi(const MatchInfo& info) {
  fulbito_match_info to{};
  to.colour = info.team == TeamId::kBlue ? FULBITO_BLUE : FULBITO_YELLOW;
  to.left = info.side == Side::kLeft;
  to.seed = info.seed;
  to.dt = info.dt();
  to.observation_age = info.observation_age;
  to.position_noise = info.position_noise;
  to.heading_noise = info.heading_noise;
  to.dropout = info.dropout;
  to.decision_seconds =
      info.decision_time ? info.decision_time->decision : std::numeric_limits<double>::infinity();
  to.decision_bank = info.decision_time ? info.decision_time->bank : 0.0;
  to.decisions_held = info.decision_time ? info.decision_time->held : 0;
  to.field = toAbi(info.field);
  to.robot = toAbi(info.robot);
  to.ball = toAbi(info.ball);
  to.physics = toAbi(info.physics);
  to.rules = toAbi(info.rules);
  return to;
}

void toAbi(const Observation& seen, fulbito_observation& to) {
  const int size = std::clamp(seen.team_size, 0, kMaxTeamSize);
  to.tick = seen.tick;
  to.dt = seen.dt;
  to.ball = {toAbi(seen.ball.position), toAbi(seen.ball.velocity)};
  to.since_restart = seen.since_restart;
  to.remaining = seen.remaining;
  to.team_size = size;
  to.period = seen.period;
  to.own_score = seen.own_score;
  to.opponent_score = seen.opponent_score;
  to.restart = static_cast<std::uint32_t>(seen.restart);
  to.playing = seen.playing;
  to.restart_is_ours = seen.restart_is_ours;
  to.wants_drawings = seen.wants_drawings;
  robotsToAbi(seen.own, size, to.own);
  robotsToAbi(seen.opponents, size, to.opponents);
  for (int i = 0; i < size; ++i) to.sent[i] = toAbi(seen.sent[static_cast<std::size_t>(i)]);
}

fulbito_call toAbi(const GameEvent& event) {
  fulbito_call to{};
  to.tick = event.tick;
  to.play_time = event.play_time;
  to.period = event.period;
  to.team = event.team ? static_cast<int32_t>(*event.team) : -1;
  to.robot = event.robot ? *event.robot : -1;
  to.place = toAbi(event.place);
  to.value = event.value;
  to.threshold = event.threshold;
  to.margin = event.margin;
  copyName(event.clause, to.clause);
  copyName(event.law, to.law);
  return to;
}

void toAbi(const PlacementRequest& request, fulbito_placement_request& to) {
  to.kind = static_cast<std::uint32_t>(request.kind);
  to.ours = request.ours;
  to.has_opponents = request.opponents.has_value();
  to.ball = toAbi(request.ball);
  to.delay = request.delay;
  to.defaults = posesToAbi(request.defaults);
  to.opponents = posesToAbi(request.opponents.value_or(TeamPlacement{}));
  to.cause = toAbi(request.cause);
  toAbi(request.now, to.now);
}

void toAbi(const PlayStop& stop, fulbito_stop& to) {
  to.cause = toAbi(stop.cause);
  toAbi(stop.now, to.now);
}

fulbito_end toAbi(const MatchEnd& end) {
  fulbito_end to{};
  to.reason = static_cast<std::uint32_t>(end.reason);
  to.winner = end.winner ? static_cast<int32_t>(*end.winner) : -1;
  to.tick = end.tick;
  to.own_score = end.own_score;
  to.opponent_score = end.opponent_score;
  to.cause = toAbi(end.cause);
  return to;
}

fulbito_exercise toAbi(const Exercise& exercise) {
  return {static_cast<std::uint32_t>(exercise.kind),
          0,
          toAbi(exercise.target),
          exercise.heading,
          exercise.speed,
          exercise.horizon};
}

CommandRoom::CommandRoom() : drawings_(kMostDrawings) {
  const GoTo by_default;
  for (fulbito_robot_command& robot : still_.robots) {
    robot.go_to.speed_limit = by_default.speed_limit;
    robot.go_to.tolerance = by_default.tolerance;
    robot.go_to.avoid_mates = by_default.avoid_mates;
    robot.go_to.avoid_opponents = by_default.avoid_opponents;
    robot.go_to.either_front = by_default.either_front;
  }
}

fulbito_team_command CommandRoom::open(bool drawings_wanted) {
  still_.drawings = drawings_wanted ? drawings_.data() : nullptr;
  still_.drawing_capacity = drawings_wanted ? kMostDrawings : 0;
  return still_;
}

void CommandRoom::close(fulbito_team_command& command) {
  command.drawings = still_.drawings;
  command.drawing_capacity = still_.drawing_capacity;
  command.drawing_count = std::min(command.drawing_count, command.drawing_capacity);
}

void fromAbi(const fulbito_team_command& command, int team_size, TeamCommand& to) {
  for (std::size_t i = 0; i < static_cast<std::size_t>(team_size); ++i) {
    to.robots[i] = fromAbi(command.robots[i]);
    to.roles[i] = static_cast<std::uint8_t>(std::min<std::uint32_t>(command.robots[i].role, 255));
  }
  const std::uint32_t count = std::min(command.drawing_count, command.drawing_capacity);
  to.drawings.resize(count);
  std::size_t used = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (command.drawings[i].kind > FULBITO_TEXT) continue;
    fromAbi(command.drawings[i], to.drawings[used++]);
  }
  to.drawings.resize(used);
}

TeamProposal fromAbi(const fulbito_placement& placement) {
  TeamProposal to;
  for (std::size_t i = 0; i < to.robots.size(); ++i) {
    if (placement.robots.present[i] != 0) to.robots[i] = fromAbi(placement.robots.pose[i]);
  }
  if (placement.has_ball != 0) to.ball = fromAbi(placement.ball);
  return to;
}

}  // namespace fulbito
