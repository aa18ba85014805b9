#pragma once

#include <string>

#include "replays/recording_salvage.hpp"

namespace fulbito {

/// The result of a repair.
struct Repair {
  std::string bytes;  ///< bytes of the repaired recording
  std::int64_t plays = 0;
  Tick ticks = 0;
  Tick lost_ticks = 0;  ///< number of lost ticks, as far as known
  int gaps = 0;         ///< number of gaps
  bool end_lost = false;
};

/// A valid recording of all readable plays. Each play has its own world, so plays after the damage are kept
/// too. Of a damaged play, the part before the damage remains. All plays are simulated again; after a gap the
/// running hash differs from the original's. Errors: kBadInput if no play is readable, or the simulation
/// differs.
Result<Repair> repair(const Salvage& salvage);

}  // namespace fulbito
