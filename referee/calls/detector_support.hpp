#pragma once

#include <algorithm>
#include <cmath>

#include "fulbito/referee.hpp"
#include "referee/calls/detectors.hpp"
#include "referee/state/ticks.hpp"

/// Helpers shared by several detectors.
namespace fulbito {

inline TeamId defenderOf(const RefereeState& state, Side side) {
  return side == state.blue_side ? TeamId::kBlue : TeamId::kYellow;
}
inline Side halfOf(Vec2 point) { return point.x < 0.0 ? Side::kLeft : Side::kRight; }
inline const GoalAreaReport& at(const AreaReport& areas, Side side) {
  return areas[static_cast<std::size_t>(side)];
}
inline bool holds(RobotSet set, std::size_t robot) { return (set >> robot & 1U) != 0; }
inline std::size_t robotsIn(const MatchView& view) {
  return std::min({view.ids.size(), view.robots.size(), kMostRobots});
}
inline bool isRobot(BodyId body, const MatchView& view) {
  return body.kind == BodyKind::kRobot && body.index < robotsIn(view);
}

/// Whether `tick` is at most `seconds` before now.
inline bool recent(const DetectorInput& in, Tick tick, double seconds) {
  const Tick age = in.view.tick - tick;
  // Most touches happened in this tick or never: both cases need no division.
  return age == 0 || (age < -kLongAgo / 2 && age <= ticksOf(seconds, in.setup.dt));
}
/// Whether play has run for at least this time [s].
inline bool cooledDown(const DetectorInput& in, double seconds) {
  return in.view.tick - in.state.play_began >= ticksOf(seconds, in.setup.dt);
}

/// Whether a robot of the team has its centre within `lengths` robot lengths of the ball.
inline bool disputes(const MatchView& view, const RobotModel& robot, TeamId team, double lengths) {
  const double reach = lengths * robot.length;
  for (std::size_t i = 0; i < robotsIn(view); ++i) {
    if (view.ids[i].team != team) continue;
    if (squaredNorm(view.robots[i].pose.position - view.ball.position) <= reach * reach) return true;
  }
  return false;
}
inline bool disputes(const DetectorInput& in, TeamId team, double lengths) {
  return disputes(in.view, in.setup.robot, team, lengths);
}

/// A finding with the fields that all events share.
inline Finding makeFinding(const DetectorInput& in, std::string_view clause, std::string_view law,
                           RestartKind restart, TeamId restart_team) {
  Finding call;
  call.event.tick = in.view.tick;
  call.event.play_time = static_cast<double>(in.state.play_ticks) * in.setup.dt;
  call.event.period = static_cast<std::uint8_t>(in.state.period);
  call.event.clause = clause;
  call.event.law = law;
  call.event.place = in.view.ball.position;
  call.restart = restart;
  call.restart_team = restart_team;
  call.ball = in.view.ball.position;
  return call;
}

/// Sets the robot at fault.
inline void blame(Finding& call, RobotId robot) {
  call.event.team = robot.team;
  call.event.robot = robot.number;
}

inline void measure(Finding& call, double value, double threshold) {
  call.event.value = value;
  call.event.threshold = threshold;
  call.event.margin = std::abs(value - threshold);
}
inline void measureTicks(const DetectorInput& in, Finding& call, Tick ticks, double threshold) {
  measure(call, static_cast<double>(ticks) * in.setup.dt, threshold);
}

}  // namespace fulbito
