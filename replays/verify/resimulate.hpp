#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/sim/world.hpp"
#include "replays/recording_reader.hpp"

namespace fulbito {

/// The beginning of a play while a recording is played again.
struct ReplayedPlay {
  const RecordedPlay* recorded = nullptr;
  std::int64_t number = 0;       ///< from 0
  const World* world = nullptr;  ///< new, from the recorded start
  std::span<const RobotId> ids;  ///< of the world's robots; of a trial, blue 0
  std::span<const std::size_t>
      bodies;              ///< of the header: robots, balls and obstacles of the world, in this order
  std::uint64_t hash = 0;  ///< running hash as it was computed again up to here
};

/// One tick of a recording, played again.
struct ReplayedTick {
  Tick tick = 0;  ///< of the recording, after the step
  const World* world = nullptr;
  std::span<const RobotId> ids;
  std::span<const std::size_t> bodies;    ///< see ReplayedPlay
  std::span<const WheelSpeeds> commands;  ///< as recorded, one a robot of the world
  std::uint64_t hash = 0;                 ///< running, computed again from the play's recorded one
  const RecordedChunk* chunk = nullptr;   ///< what was recorded around this tick
  std::size_t row = 0;                    ///< of the tick in it
};

/// The bodies' hashes that were recorded of this tick; null but once a second.
const RecordedCheck* checkAt(const ReplayedTick& tick);
/// Whether the tick came out as it was recorded, by all hashes there are of it.
bool asRecorded(const ReplayedTick& tick);

/// Someone who is shown a recording as it is played again.
class ReplayVisitor {
 public:
  virtual ~ReplayVisitor() = default;
  /// A part of the recording was unpacked; its plays and ticks follow.
  virtual void chunkBegins(const RecordedChunk&) {}
  /// @{ False ends the replay there.
  virtual bool playBegins(const ReplayedPlay&) { return true; }
  virtual bool ticked(const ReplayedTick&) { return true; }
  /// @}
};

/// Plays a recording again: builds every play's world from its recorded start and applies the recorded
/// commands. No team and no referee takes part. Errors: kBadInput naming the file, for a recipe that makes no
/// world.
Result<void> resimulate(const RecordingReader& recording, ReplayVisitor& visitor);

/// Plays of a recording, counted from 0, both included.
struct PlayRange {
  std::int64_t first = 0;
  std::int64_t last = std::numeric_limits<std::int64_t>::max();
};
/// Only these plays of it, each a world of its own.
Result<void> resimulate(const RecordingReader& recording, const PlayRange& plays, ReplayVisitor& visitor);

/// Gives the chunks of a recording one after the other; nothing after the last one.
using ChunkSource = std::function<Result<std::optional<RecordedChunk>>()>;
/// The same of chunks from anywhere. Some may be missing: what belongs to plays that began in them is left
/// out.
Result<void> resimulate(const RecordingHeader& header, const ChunkSource& chunks, const PlayRange& plays,
                        ReplayVisitor& visitor);

/// Name of a body: "blue 0", "robot 0" of a trial, "ball", "obstacle 3".
std::string bodyName(const RecordingHeader& header, std::size_t body);

}  // namespace fulbito
