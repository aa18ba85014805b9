#include "referee/check_places.hpp"

#include <fmt/format.h>

#include "referee/restart_call.hpp"
#include "referee/restart_placement.hpp"

namespace fulbito {

std::vector<std::string> findBadPlaces(const Rules& rules, const FieldGeometry& field,
                                       const RobotModel& robot) {
  RefereeSetup setup;
  setup.rules = rules;
  setup.field = field;
  setup.robot = robot;
  const RefereeState state;
  std::vector<std::string> bad;
  for (const RestartKind kind : {RestartKind::kKickOff, RestartKind::kFreeBall, RestartKind::kFreeKick,
                                 RestartKind::kPenalty, RestartKind::kGoalKick}) {
    // A ball at +x gives a free ball to blue, which defends -x.
    const RestartCall call = makeCall(setup, state, {kind, TeamId::kBlue, {1.0, 1.0}, nullptr});
    const auto flaw = findPlacementFlaw(setup, state, call, call.defaults);
    if (!flaw) continue;
    bad.push_back(fmt::format("{}: robot {} of the {} team {}", nameOf(kind), flaw->robot,
                              flaw->team == call.team ? "taking" : "other", flaw->reason));
  }
  return bad;
}

}  // namespace fulbito
