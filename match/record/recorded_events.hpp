#pragma once

#include <optional>
#include <vector>

#include "match/report/event_lines.hpp"
#include "replays/recording_reader.hpp"

namespace fulbito {

/// One line of a recording's record: a call of the referee, or a restart.
struct ReplayEvent {
  RecordedEvent call;  ///< of a restart: tick, time, period, team that takes it, and the ball's place
  std::optional<RestartKind> restart;  ///< empty: a call
  PerTeam<int> score{};                ///< after it
};

/// All calls and restarts of a recording in the order in which they happened. Errors: kBadInput.
Result<std::vector<ReplayEvent>> eventsOf(const RecordingReader& recording);

/// The lines that `EventLines` wrote while the match was played; of a trial, its first and last line.
/// Errors: kBadInput, also for a recipe that cannot be understood.
Result<void> writeEventLines(const RecordingReader& recording, const EventLines::Sink& sink);

}  // namespace fulbito
