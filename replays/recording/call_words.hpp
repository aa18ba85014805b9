#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fulbito/recording.hpp"

/// Words and colours of calls and restarts, for pictures, films, the window, the HTML page and tables.
namespace fulbito {

/// A call or a restart in words.
struct CallWords {
  std::string title;   ///< e.g. "Goal kick"; empty: no banner, as for a repaired placement
  std::string detail;  ///< e.g. "keeper charged", or the specification of the scoring team
  /// The team that benefits; it gives the colour. For goals, restarts, advantages, wins and kicks of a
  /// shoot-out: the team that scored, takes the restart, leads, won or had the kick. For a foul: the team
  /// that did not commit it. Empty for free balls, false starts and ends of periods.
  std::optional<TeamId> favours;
};

/// The words for a call. `teams`: specifications of blue and yellow for details that name a team; may be
/// empty.
CallWords wordsOf(const RecordedEvent& event, const std::vector<std::string>& teams);

/// The words for a restart without a call; `team` takes it. Empty for a placed state.
CallWords wordsOf(RestartKind kind, TeamId team, const std::vector<std::string>& teams);

/// The measured value with its unit and limit: "pressed with 0.12 N s (limit 0.02 N s)". Empty without a
/// value.
std::string measuredText(const RecordedEvent& event);

}  // namespace fulbito
