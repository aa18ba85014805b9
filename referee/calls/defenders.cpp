#include "referee/calls/area_crowd.hpp"
#include "referee/calls/calls.hpp"
#include "referee/calls/detector_support.hpp"

namespace fulbito {

std::optional<AreaFoul> detectDefenders(const DetectorInput& in, const TouchMemory& touches,
                                        const PresenceMemory& presence) {
  const AreaRules& rules = in.setup.rules.areas;
  const Side side = halfOf(in.view.ball.position);
  const GoalAreaReport& area = at(in.areas, side);
  if (!area.ball && !area.ball_in_big) return std::nullopt;
  AreaCrowd crowd{side, false, area.defenders, 0, rules.defenders_take_part, rules.defenders_max};
  AreaCrowd big{side, true, area.big_defenders, 0, rules.defenders_take_part, rules.big_defenders_max};
  if (rules.defenders_take_part) {
    const RobotSet all = area.defenders | area.big_defenders;
    crowd.taking_part = touchedRecently(in, all, touches.ball) | touchedRecently(in, all, touches.opponent);
    big.taking_part = crowd.taking_part;
  }
  if (area.ball) {
    if (auto foul = foulOf(crowd, in, presence)) return foul;
  }
  if (area.ball_in_big) return foulOf(big, in, presence);
  return std::nullopt;
}

}  // namespace fulbito
