#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"

namespace fulbito {
namespace {

void beginCount(StuckMemory& memory, const MatchView& view) {
  memory = {true, view.tick, view.ball.position, -1, 0};
}

void countByRadius(const StuckRules& rules, const MatchView& view, StuckMemory& memory) {
  const bool left = squaredNorm(view.ball.position - memory.anchor) > rules.radius * rules.radius;
  if (!memory.counting || left) beginCount(memory, view);
}

void countBySpeed(const StuckRules& rules, const MatchView& view, double dt, StuckMemory& memory) {
  const double speed2 = squaredNorm(view.ball.velocity);
  if (!memory.counting) {
    if (speed2 <= rules.speed * rules.speed) beginCount(memory, view);
    return;
  }
  if (speed2 <= rules.release_speed * rules.release_speed) {
    memory.fast_since = -1;
    return;
  }
  if (memory.fast_since < 0) memory.fast_since = view.tick;
  if (view.tick - memory.fast_since + 1 >= ticksOf(rules.release_seconds, dt)) memory.counting = false;
}

/// The team that attacks the half with the ball; on the half-way line, the team that did not begin this play,
/// so that neither side nor colour has an advantage.
TeamId freeBallTeam(const DetectorInput& in) {
  const Vec2 ball = in.view.ball.position;
  return ball.x == 0.0 ? other(in.state.last.team) : other(defenderOf(in.state, halfOf(ball)));
}

/// The mark in the ball's quarter. On the field's long axis: the mark on the attackers' left.
Vec2 freeBallMark(const DetectorInput& in, TeamId attackers) {
  const Vec2 mark = in.setup.field.free_ball_mark;
  const double forward = in.state.sideOf(attackers) == Side::kLeft ? 1.0 : -1.0;
  const double y = in.view.ball.position.y;
  const double up = y < 0.0 ? -1.0 : 1.0;
  return {forward * mark.x, (y == 0.0 ? forward : up) * mark.y};
}

Finding freeBall(const DetectorInput& in) {
  const TeamId attackers = freeBallTeam(in);
  Finding call = makeFinding(in, clause::kFreeBall, "14", RestartKind::kFreeBall, attackers);
  call.ball = freeBallMark(in, attackers);
  return call;
}

Finding stuckInArea(const DetectorInput& in, Side side) {
  const StuckRules& rules = in.setup.rules.stuck;
  const TeamId defenders = defenderOf(in.state, side), attackers = other(defenders);
  const bool disputed =
      disputes(in, defenders, rules.dispute_lengths) && disputes(in, attackers, rules.dispute_lengths);
  if (disputed || rules.undisputed == UndisputedCall::kGoalKick) {
    Finding call = makeFinding(in, clause::kGoalKickStuck, "13", RestartKind::kGoalKick, defenders);
    call.event.team = attackers;
    return call;
  }
  Finding call = makeFinding(in, clause::kPenaltyStuck, "8.1", RestartKind::kPenalty, attackers);
  call.event.team = defenders;
  return call;
}

/// A stalemate needs robots that dispute the ball. If only a keeper has it, law 8.1 applies, with its own
/// count.
bool keeperControls(const DetectorInput& in, Side side, const KeeperMemory& keepers) {
  return keepers.control[indexOf(defenderOf(in.state, side))].last == in.view.tick;
}

}  // namespace

std::optional<Finding> detectStuckBall(const DetectorInput& in, const KeeperMemory& keepers,
                                       StuckMemory& memory) {
  const StuckRules& rules = in.setup.rules.stuck;
  if (rules.measure == StuckMeasure::kRadius) {
    countByRadius(rules, in.view, memory);
  } else {
    countBySpeed(rules, in.view, in.setup.dt, memory);
  }
  if (!memory.counting) return std::nullopt;
  const Side side = halfOf(in.view.ball.position);
  if (keeperControls(in, side, keepers)) {
    ++memory.since;
    return std::nullopt;
  }
  const bool inside = at(in.areas, side).ball;
  if (inside) ++memory.in_area;
  const Tick age = in.view.tick - memory.since;
  const bool in_area = rules.place == StuckPlace::kNow ? inside : 2 * memory.in_area > age;
  const double allowed = in_area ? rules.area_seconds : rules.seconds;
  if (age < ticksOf(allowed, in.setup.dt)) return std::nullopt;
  Finding call = in_area ? stuckInArea(in, side) : freeBall(in);
  measureTicks(in, call, age, allowed);
  return call;
}

}  // namespace fulbito
