#include "referee/calls/area_crowd.hpp"
#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"

namespace fulbito {
namespace {

std::optional<AreaFoul> foulAt(const DetectorInput& in, Side side, const TouchMemory& touches,
                               const PresenceMemory& presence) {
  const AreaRules& rules = in.setup.rules.areas;
  const GoalAreaReport& area = at(in.areas, side);
  AreaCrowd crowd{side, false, area.attackers, 0, rules.attackers_take_part, rules.attackers_max};
  AreaCrowd big{side, true, area.big_attackers, 0, rules.attackers_take_part, rules.big_attackers_max};
  if (rules.attackers_take_part) {
    const RobotSet all = area.attackers | area.big_attackers;
    crowd.taking_part = touchedRecently(in, all, touches.ball) | touchedRecently(in, all, touches.keeper);
    big.taking_part = crowd.taking_part;
  }
  if (area.ball || !rules.attackers_need_ball) {
    if (auto foul = foulOf(crowd, in, presence)) return foul;
  }
  if (area.ball_in_big || !rules.attackers_need_ball) return foulOf(big, in, presence);
  return std::nullopt;
}

}  // namespace

std::optional<AreaFoul> detectAttackers(const DetectorInput& in, const TouchMemory& touches,
                                        const PresenceMemory& presence) {
  const Side first = halfOf(in.view.ball.position);
  for (const Side side : {first, opposite(first)}) {
    const GoalAreaReport& area = at(in.areas, side);
    if ((area.attackers | area.big_attackers) == 0) continue;
    if (auto foul = foulAt(in, side, touches, presence)) return foul;
  }
  return std::nullopt;
}

}  // namespace fulbito
