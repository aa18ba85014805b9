#pragma once

#include <optional>
#include <string_view>

#include "fulbito/match.hpp"

namespace fulbito {

/// Finds goals that a team scores shortly after its own foul.
class FoulGoalFinder {
 public:
  /// Processes an event after `played` ticks of play of `dt` [s]. If the event is a goal at most
  /// `kFoulPaysWithin` after a foul of the scoring team, returns the clause of the foul.
  std::optional<std::string_view> take(const GameEvent& event, Tick played, double dt);

 private:
  struct Foul {
    Tick played = 0;
    std::string_view clause;
  };
  PerTeam<std::optional<Foul>> last_;
};

}  // namespace fulbito
