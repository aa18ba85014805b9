#include "referee/detect_stuck_ball.hpp"

#include <algorithm>

#include "referee/detector_support.hpp"

namespace fulbito {
namespace {

void restartCount(StuckMemory& memory, const MatchView& view) {
  memory = {true, view.tick, view.ball.position, -1};
}

void countByRadius(const StuckRules& rules, const MatchView& view, StuckMemory& memory) {
  const bool left = squaredNorm(view.ball.position - memory.anchor) > rules.radius * rules.radius;
  if (!memory.counting || left) restartCount(memory, view);
}

void countBySpeed(const StuckRules& rules, const MatchView& view, double dt, StuckMemory& memory) {
  const double speed2 = squaredNorm(view.ball.velocity);
  if (!memory.counting) {
    if (speed2 <= rules.speed * rules.speed) restartCount(memory, view);
    return;
  }
  if (speed2 <= rules.release_speed * rules.release_speed) {
    memory.fast_since = -1;
    return;
  }
  if (memory.fast_since < 0) memory.fast_since = view.tick;
  if (view.tick - memory.fast_since >= ticksOf(rules.release_seconds, dt)) memory.counting = false;
}

bool disputed(const DetectorInput& in) {
  const double reach = in.setup.rules.stuck.dispute_lengths * in.setup.robot.length;
  PerTeam<bool> is_near{};
  const std::size_t count = std::min(in.view.ids.size(), in.view.robots.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Vec2 gap = in.view.robots[i].pose.position - in.view.ball.position;
    if (squaredNorm(gap) <= reach * reach) is_near[indexOf(in.view.ids[i].team)] = true;
  }
  return is_near[0] && is_near[1];
}

/// The team that attacks the half where the ball lies; on the halfway line the one that did not begin this
/// play, so that neither side nor colour has an advantage.
TeamId freeBallTeam(const DetectorInput& in) {
  const double x = in.view.ball.position.x;
  if (x == 0.0) return other(in.state.last.team);
  return other(defenderOf(in.state, x < 0.0 ? Side::kLeft : Side::kRight));
}

/// The mark of the ball's quarter. On the field's long axis: the one to the attackers' left.
Vec2 freeBallMark(const DetectorInput& in, TeamId attackers) {
  const Vec2 mark = in.setup.field.free_ball_mark;
  const double forward = sideOf(in.state, attackers) == Side::kLeft ? 1.0 : -1.0;
  const double y = in.view.ball.position.y;
  const double up = y == 0.0 ? forward : (y < 0.0 ? -1.0 : 1.0);
  return {forward * mark.x, up * mark.y};
}

Finding freeBall(const DetectorInput& in) {
  Finding call;
  call.event = makeEvent(in, clause::kFreeBall, "14");
  call.restart = RestartKind::kFreeBall;
  call.restart_team = freeBallTeam(in);
  call.ball = freeBallMark(in, call.restart_team);
  return call;
}

Finding stuckInArea(const DetectorInput& in, Side side) {
  const TeamId defenders = defenderOf(in.state, side);
  const bool dispute = disputed(in);
  Finding call;
  if (dispute || in.setup.rules.stuck.undisputed == UndisputedCall::kGoalKick) {
    call.event = makeEvent(in, clause::kGoalKickStuck, "13");
    call.event.team = other(defenders);
    call.restart = RestartKind::kGoalKick;
    call.restart_team = defenders;
  } else {
    call.event = makeEvent(in, clause::kPenaltyStuck, "8.1");
    call.event.team = defenders;
    call.restart = RestartKind::kPenalty;
    call.restart_team = other(defenders);
  }
  call.ball = in.view.ball.position;
  return call;
}

}  // namespace

std::optional<Finding> detectStuckBall(const DetectorInput& in, StuckMemory& memory) {
  const StuckRules& rules = in.setup.rules.stuck;
  if (rules.measure == StuckMeasure::kRadius) {
    countByRadius(rules, in.view, memory);
  } else {
    countBySpeed(rules, in.view, in.setup.dt, memory);
  }
  if (!memory.counting) return std::nullopt;
  const Side side = in.view.ball.position.x < 0.0 ? Side::kLeft : Side::kRight;
  const bool in_area = in.areas[static_cast<std::size_t>(side)].ball;
  const double allowed = in_area ? rules.area_seconds : rules.seconds;
  const Tick age = in.view.tick - memory.since;
  if (age < ticksOf(allowed, in.setup.dt)) return std::nullopt;
  Finding call = in_area ? stuckInArea(in, side) : freeBall(in);
  measure(call.event, static_cast<double>(age) * in.setup.dt, allowed);
  return call;
}

}  // namespace fulbito
