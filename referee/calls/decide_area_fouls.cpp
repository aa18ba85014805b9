#include "referee/calls/decide_area_fouls.hpp"

#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"

namespace fulbito {
namespace {

bool ballInside(const DetectorInput& in, const AreaFoul& foul) {
  const GoalAreaReport& area = at(in.areas, foul.side);
  return foul.big ? area.ball_in_big : area.ball;
}

void note(const DetectorInput& in, const std::optional<AreaFoul>& seen, std::optional<PendingFoul>& pending) {
  if (seen && !pending) pending = PendingFoul{*seen, in.view.tick, 0, false};
  if (!pending) return;
  if (seen) ++pending->ticks;
  pending->with_ball = pending->with_ball || ballInside(in, pending->foul);
}

bool due(const DetectorInput& in, const std::optional<PendingFoul>& pending, double wait) {
  if (!pending) return false;
  if (in.view.tick - pending->since >= ticksOf(wait, in.setup.dt)) return true;
  return pending->with_ball && !ballInside(in, pending->foul);
}

Finding callOf(const DetectorInput& in, const PendingFoul& pending, bool attack) {
  const RobotId robot = in.view.ids[pending.foul.robot];
  Finding call = attack
                     ? makeFinding(in, clause::kAttackers, "8.2", RestartKind::kGoalKick, other(robot.team))
                     : makeFinding(in, clause::kDefenders, "8.3", RestartKind::kPenalty, other(robot.team));
  blame(call, robot);
  measure(call, pending.foul.count, pending.foul.allowed);
  return call;
}

bool atOneGoal(const AreaFoulMemory& memory) {
  return memory.attack && memory.defence && memory.attack->foul.side == memory.defence->foul.side;
}

/// Whether the attackers' foul counts instead of the defenders' at the same goal.
bool attackCounts(const DetectorInput& in, const AreaFoulMemory& memory) {
  if (!atOneGoal(memory)) return memory.attack.has_value();
  return in.setup.rules.areas.both == BothFouls::kAttackers || memory.attack->ticks >= memory.defence->ticks;
}

}  // namespace

void noteAreaFouls(const DetectorInput& in, const TouchMemory& touches, const PresenceMemory& presence,
                   AreaFoulMemory& memory) {
  const AreaRules& rules = in.setup.rules.areas;
  if (!cooledDown(in, rules.cool_down)) return;
  if (rules.attackers) note(in, detectAttackers(in, touches, presence), memory.attack);
  if (rules.defenders) note(in, detectDefenders(in, touches, presence), memory.defence);
}

Finding decideGoal(const DetectorInput& in, const Finding& goal, const AreaFoulMemory& memory) {
  if (!in.setup.rules.goal.attack_foul_voids || !memory.attack) return goal;
  const bool here = memory.attack->foul.side == halfOf(in.view.ball.position);
  return here && attackCounts(in, memory) ? callOf(in, *memory.attack, true) : goal;
}

std::optional<Finding> decideAreaFouls(const DetectorInput& in, const AreaFoulMemory& memory) {
  const AreaRules& rules = in.setup.rules.areas;
  const auto& [attack, defence] = memory;
  const bool attack_due = due(in, attack, rules.attackers_wait);
  const bool defence_due = due(in, defence, rules.defenders_wait);
  if (!attack_due && !defence_due) return std::nullopt;
  const bool attack_first = atOneGoal(memory) ? attackCounts(in, memory) : attack_due;
  if (attack && attack_first) return callOf(in, *attack, true);
  if (defence) return callOf(in, *defence, false);
  return std::nullopt;
}

}  // namespace fulbito
