#pragma once

#include <optional>
#include <string>
#include <vector>

#include "replays/recording/recording.hpp"

/// What a referee's calls and restarts read as, and whose colour they have: one place for pictures, films,
/// the window, the HTML page and tables.
namespace fulbito {

/// A call or a restart for a reader.
struct CallWords {
  std::string title;   ///< e.g. "Goal kick"; empty: no news, as how a placement was repaired
  std::string detail;  ///< e.g. "keeper charged", or the specification of the team that scored
  /// Whose colour it has: the team that gains by it. That is who scored, who takes the restart, who leads or
  /// won, whose kick of the shoot-out it was; of a foul the other team than the one it is called against.
  /// None where no team has the ball for it: free balls, false starts, ends of periods.
  std::optional<TeamId> favours;
};

/// A call in words. `teams`: specifications of blue and yellow, for details that name one; may be empty.
CallWords wordsOf(const RecordedEvent& event, const std::vector<std::string>& teams);

/// A restart in words, for those that no call tells of; `team` takes it. Empty for a placed state.
CallWords wordsOf(RestartKind kind, TeamId team, const std::vector<std::string>& teams);

/// What was measured, with its unit, and what the rule allows: "pressed with 0.12 N s (limit 0.02 N s)".
/// Empty where nothing was.
std::string measuredText(const RecordedEvent& event);

}  // namespace fulbito
