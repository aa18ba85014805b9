#pragma once

#include "fulbito/recording.hpp"

namespace fulbito {

/// Simulates a recording of level recipe again and returns one of level full, in memory: the same plays,
/// commands, events and hashes, with states as `MatchRecorder` samples them. Debug drawings of teams cannot
/// be recovered. Returns a full recording unchanged. Errors: as `resimulate`; kBadInput naming the first
/// differing tick.
Result<RecordingReader> expanded(const RecordingReader& recipe);

}  // namespace fulbito
