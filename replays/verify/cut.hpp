#pragma once

#include <string>

#include "replays/verify/resimulate.hpp"

namespace fulbito {

/// The plays that have a part in these seconds of the recording. Errors: kUsage when none has.
Result<PlayRange> playsBetween(const RecordingReader& recording, double from, double to);

/// A recording of these plays alone, in memory. It is played again while it is cut; hashes go on from what
/// they were, and `more` of its recipe says where it was cut: cut_plays (of those there were, counted from
/// 1), cut_from_s, cut_of_hash. Errors: kUsage for plays that are not there; kBadInput where the recording
/// does not come out the same.
Result<std::string> cutPlays(const RecordingReader& recording, const PlayRange& plays);

}  // namespace fulbito
