#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"
#include "referee/calls/note_presence.hpp"

namespace fulbito {
namespace {

/// The robot that charges a keeper in this contact.
std::optional<std::size_t> chargerIn(const DetectorInput& in, const ContactEvent& contact,
                                     const PresenceMemory& presence) {
  if (!isRobot(contact.a, in.view) || !isRobot(contact.b, in.view)) return std::nullopt;
  const std::size_t a = contact.a.index, b = contact.b.index;
  if (in.view.ids[a].team == in.view.ids[b].team) return std::nullopt;
  const bool a_keeps = keepsGoal(in, a, presence), b_keeps = keepsGoal(in, b, presence);
  if (!a_keeps && !b_keeps) return std::nullopt;
  const std::size_t keeper = a_keeps ? a : b;
  const Side side = in.state.sideOf(in.view.ids[keeper].team);
  const AreaShape area = goalAreaOf(in.setup.field, in.setup.rules.areas.arc);
  if (!contains(area, intoGoalFrame(in.setup.field, side, contact.point))) return std::nullopt;
  return a_keeps ? b : a;
}

}  // namespace

std::optional<Finding> detectKeeperCharged(const DetectorInput& in, const TouchMemory& touches,
                                           const PresenceMemory& presence, KeeperMemory& memory) {
  const KeeperRules& rules = in.setup.rules.keeper;
  if (!rules.charged || !cooledDown(in, rules.cool_down)) return std::nullopt;
  for (const ContactEvent& contact : in.view.contacts) {
    const auto charger = chargerIn(in, contact, presence);
    if (!charger) continue;
    Spell& spell = memory.charges[*charger];
    if (recent(in, touches.ball[*charger], rules.part_seconds)) {
      spell = {};
      continue;
    }
    spell.add(in.view.tick, ticksOf(rules.charge_release, in.setup.dt), contact.impulse);
    if (spell.ticks(in.view.tick) < ticksOf(rules.charge_seconds, in.setup.dt)) continue;
    if (spell.sum < rules.charge_impulse) continue;
    const RobotId robot = in.view.ids[*charger];
    Finding call = makeFinding(in, clause::kKeeperCharged, "13", RestartKind::kGoalKick, other(robot.team));
    blame(call, robot);
    measure(call, spell.sum, rules.charge_impulse);
    return call;
  }
  return std::nullopt;
}

}  // namespace fulbito
