#include "referee/calls/area_crowd.hpp"

#include <bit>

#include "referee/calls/detector_support.hpp"

namespace fulbito {
namespace {

RobotSet notExcused(const DetectorInput& in, RobotSet inside, const PresenceMemory& presence) {
  RobotSet counted = 0;
  for (std::size_t i = 0; i < robotsIn(in.view); ++i) {
    if (presence.excused_until[i] < in.view.tick) counted |= inside & (RobotSet{1} << i);
  }
  return counted;
}

int cameNoLater(RobotSet counted, std::size_t robot, const RobotTicks& entered) {
  int others = 0;
  for (std::size_t i = 0; i < kMostRobots; ++i) {
    if (i != robot && holds(counted, i) && entered[i] <= entered[robot]) ++others;
  }
  return others;
}

}  // namespace

RobotSet touchedRecently(const DetectorInput& in, RobotSet among, const RobotTicks& touched) {
  const Tick earliest = in.view.tick - ticksOf(in.setup.rules.areas.part_seconds, in.setup.dt);
  RobotSet of_late = 0;
  for (std::size_t i = 0; i < robotsIn(in.view); ++i) {
    if (holds(among, i) && touched[i] >= earliest) of_late |= RobotSet{1} << i;
  }
  return of_late;
}

std::optional<AreaFoul> foulOf(const AreaCrowd& crowd, const DetectorInput& in,
                               const PresenceMemory& presence) {
  if (std::popcount(crowd.inside) <= crowd.allowed) return std::nullopt;
  const RobotSet counted = notExcused(in, crowd.inside, presence);
  const int count = std::popcount(counted);
  if (count <= crowd.allowed) return std::nullopt;
  const RobotTicks& entered = crowd.big ? presence.big_area : presence.goal_area;
  for (std::size_t i = 0; i < robotsIn(in.view); ++i) {
    if (!holds(counted, i) || (crowd.must_take_part && !holds(crowd.taking_part, i))) continue;
    if (cameNoLater(counted, i, entered) < crowd.allowed) continue;
    return AreaFoul{crowd.side, crowd.big, i, count, crowd.allowed};
  }
  return std::nullopt;
}

}  // namespace fulbito
