#include "referee/restart_placement.hpp"

namespace fulbito {

Placement place(const RefereeSetup&, const RefereeState&, const RestartCall& call, const Proposals&,
                std::vector<GameEvent>&) {
  return call.defaults;
}

std::optional<PlacementFlaw> findPlacementFlaw(const RefereeSetup&, const RefereeState&, const RestartCall&,
                                               const Placement&) {
  return std::nullopt;
}

bool legalPlacement(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                    const Placement& placement) {
  return !findPlacementFlaw(setup, state, call, placement);
}

}  // namespace fulbito
