#pragma once

#include "replays/recording_reader.hpp"

namespace fulbito {

/// Plays a recording of the level recipe again and gives one of the level full, in memory: the same plays,
/// commands, events and hashes, and states as `MatchRecorder` would have sampled them. Debug drawings of
/// teams cannot be had again. What is full already comes back as it is, without being played. Errors: as
/// `resimulate`; kBadInput naming the first tick whose hash is not the recorded one.
Result<RecordingReader> expanded(const RecordingReader& recipe);

}  // namespace fulbito
