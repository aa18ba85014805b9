#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "fulbito/recording.hpp"
#include "fulbito/world.hpp"

namespace fulbito {

/// The start of a play in a resimulation.
struct ReplayedPlay {
  const RecordedPlay* recorded = nullptr;
  std::int64_t number = 0;       ///< number of the play, from 0
  const World* world = nullptr;  ///< created from the recorded start; null: the recording was heard
  std::span<const RobotId> ids;  ///< ids of the world's robots; blue 0 in a trial
  std::span<const std::size_t>
      bodies;              ///< header indices of the world's robots, balls and obstacles, in this order
  std::uint64_t hash = 0;  ///< running hash of the resimulation
};

/// One resimulated tick of a recording.
struct ReplayedTick {
  Tick tick = 0;                      ///< tick of the recording, after the step
  const World* world = nullptr;       ///< null: the recording was heard
  const WorldState* state = nullptr;  ///< of the world, or as heard
  std::span<const RobotId> ids;
  std::span<const std::size_t> bodies;    ///< see `ReplayedPlay`
  std::span<const WheelSpeeds> commands;  ///< as recorded, one per robot of the world
  std::uint64_t hash = 0;                 ///< running hash, continued from the play's recorded one
  const RecordedChunk* chunk = nullptr;   ///< chunk of this tick
  std::size_t row = 0;                    ///< row of the tick in the chunk
};

/// The recorded hashes of the bodies at this tick; null except once per second.
const RecordedCheck* checkAt(const ReplayedTick& tick);
/// Whether the tick matches all its recorded hashes.
bool asRecorded(const ReplayedTick& tick);

/// Visits the plays and ticks of a resimulation.
class ReplayVisitor {
 public:
  virtual ~ReplayVisitor() = default;
  /// Called when a chunk has been unpacked. Its plays and ticks follow.
  virtual void chunkBegins(const RecordedChunk&) {}
  /// @{ Returning false ends the resimulation.
  virtual bool playBegins(const ReplayedPlay&) { return true; }
  virtual bool ticked(const ReplayedTick&) { return true; }
  /// @}
};

/// Simulates a recording again: creates each play's world from its recorded start and applies the recorded
/// commands, without teams or referee. What was heard from another program is read from its samples instead.
/// Errors: kBadInput naming the file, if the recipe gives no valid world.
Result<void> resimulate(const RecordingReader& recording, ReplayVisitor& visitor);

/// Plays of a recording, counted from 0; both ends are included.
struct PlayRange {
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};
/// Simulates only these plays.
Result<void> resimulate(const RecordingReader& recording, const PlayRange& plays, ReplayVisitor& visitor);

/// Returns the chunks of a recording one after the other, then an empty value.
using ChunkSource = std::function<Result<std::optional<RecordedChunk>>()>;
/// Simulates chunks from any source. Chunks may be missing; data of plays that began in them are skipped.
Result<void> resimulate(const RecordingHeader& header, const ChunkSource& chunks, const PlayRange& plays,
                        ReplayVisitor& visitor);

/// Name of a body: "blue 0", "robot 0" (in a trial), "ball", "obstacle 3".
std::string bodyName(const RecordingHeader& header, std::size_t body);

}  // namespace fulbito
