#pragma once

#include <optional>
#include <vector>

#include "fulbito/recording.hpp"
#include "fulbito/statistics.hpp"

namespace fulbito {

/// One entry of a recording's event log: a call of the referee, or a restart.
struct ReplayEvent {
  RecordedEvent call;                  ///< for a restart: tick, time, period, taking team and ball position
  std::optional<RestartKind> restart;  ///< the kind of restart; empty for a call
  PerTeam<int> score{};                ///< score after the event
};

/// All calls and restarts of a recording, in chronological order. Errors: kBadInput.
Result<std::vector<ReplayEvent>> eventsOf(const RecordingReader& recording);

/// Writes the same lines as `EventLines` during the match; for a trial, the first and last line. Errors:
/// kBadInput, also for a recipe that does not parse.
Result<void> writeEventLines(const RecordingReader& recording, const EventLines::Sink& sink);

}  // namespace fulbito
