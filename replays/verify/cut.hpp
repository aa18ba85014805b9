#pragma once

#include <string>

#include "replays/verify/resimulate.hpp"

namespace fulbito {

/// The plays that overlap the time range from `from` to `to` [s]. Errors: kUsage if there are none.
Result<PlayRange> playsBetween(const RecordingReader& recording, double from, double to);

/// A recording of only these plays, in memory. The plays are simulated again; hashes continue from the
/// recorded ones. `more` of its recipe describes the cut: cut_plays (counted from 1), cut_from_s,
/// cut_of_hash. Errors: kUsage for plays that do not exist; kBadInput if the simulation differs from the
/// recording.
Result<std::string> cutPlays(const RecordingReader& recording, const PlayRange& plays);

}  // namespace fulbito
