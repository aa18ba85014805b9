#pragma once

#include <string>

#include "replays/recording_salvage.hpp"

namespace fulbito {

/// What a repair kept and what it could not.
struct Repair {
  std::string bytes;  ///< of the repaired recording
  std::int64_t plays = 0;
  Tick ticks = 0;
  Tick lost_ticks = 0;  ///< of the original, where its length is known
  int gaps = 0;         ///< places where something between is missing
  bool end_lost = false;
};

/// A whole recording of all plays that can be read: each is a world of its own, so that those after the
/// damage are kept too. What remains of a play whose middle was lost is its beginning. It is played again
/// meanwhile; after a gap the running hash is another than the original's. Errors: kBadInput when nothing can
/// be read, or what is left does not come out the same.
Result<Repair> repair(const Salvage& salvage);

}  // namespace fulbito
