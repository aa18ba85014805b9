#include "referee/calls/detectors.hpp"

#include "referee/calls/calls.hpp"
#include "referee/calls/decide_area_fouls.hpp"
#include "referee/calls/detector_support.hpp"
#include "referee/calls/note_presence.hpp"

namespace fulbito {
namespace {

/// The calls other than goals, in order of priority. All detectors see every tick, because they keep counts.
std::optional<Finding> detectFouls(const DetectorInput& in, DetectorMemory& memory) {
  const auto area_foul = decideAreaFouls(in, memory.area_fouls);
  const auto charged = detectKeeperCharged(in, memory.touches, memory.presence, memory.keeper);
  const auto holding_keeper = detectKeeperHolding(in, memory.presence, memory.keeper);
  const auto holding = detectHolding(in, memory.presence, memory.fouls);
  const auto push = detectPush(in, memory.touches, memory.fouls);
  const auto stuck = detectStuckBall(in, memory.keeper, memory.stuck);
  for (const auto* call : {&area_foul, &charged, &holding_keeper, &holding, &push, &stuck}) {
    if (*call) return *call;
  }
  return std::nullopt;
}

}  // namespace

std::optional<Finding> detect(const DetectorInput& in, DetectorMemory& memory) {
  memory.areas = in.areas;
  noteTouches(in, memory.presence, memory.touches);
  notePresence(in, memory.touches, memory.presence);
  noteAreaFouls(in, memory.touches, memory.presence, memory.area_fouls);
  if (auto goal = detectGoal(in, memory.touches)) return decideGoal(in, *goal, memory.area_fouls);
  return detectFouls(in, memory);
}

std::optional<Finding> detect(const MatchView& view, const RefereeSetup& setup, const RefereeState& state,
                              DetectorMemory& memory) {
  const AreaReport areas =
      reportAreas(view, setup.field, setup.robot, setup.rules.areas, state.blue_side, memory.areas);
  return detect(DetectorInput{view, setup, state, areas}, memory);
}

}  // namespace fulbito
