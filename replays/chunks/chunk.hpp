#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fulbito/recording.hpp"
#include "replays/chunks/chunk_format.hpp"
#include "replays/coding/byte_io.hpp"
#include "replays/coding/columns.hpp"
#include "replays/coding/packing.hpp"

namespace fulbito {

/// The data of a chunk before its sections.
struct ChunkHead {
  Tick first_tick = 0;
  int ticks = 0;
  std::int64_t plays_before = 0;
  std::int64_t plays = 0;  ///< plays that begin in the chunk
  std::uint64_t events = 0, drawings = 0;
  std::vector<std::uint8_t> present;  ///< see `RecordedChunk`
};

/// One tick of play: the world after its step.
struct TickData {
  Tick tick = 0;  ///< tick of the recording
  const WorldState* world = nullptr;
  std::span<const WheelSpeeds> commands;  ///< one per robot of the world
  std::uint64_t hash = 0;                 ///< running hash after the tick
  bool playing = true;
};

/// Collects a few seconds of a recording and packs them as a chunk. Reuses its memory for the next chunk.
class ChunkBuilder {
 public:
  explicit ChunkBuilder(const RecordingHeader& header);

  Tick endTick() const { return first_tick_ + ticks_; }
  int ticks() const { return ticks_; }
  /// Whether the next tick or play has to go into a new chunk.
  bool full() const;
  bool empty() const { return ticks_ == 0 && plays_ == 0 && events_.count == 0; }
  std::int64_t plays() const { return plays_before_ + plays_; }

  /// @param tick  tick of the recording at which the play begins, instead of the tick in `play`
  void play(const RecordedPlay& play, Tick tick);
  void tick(const TickData& data);
  void event(const RecordedEvent& event);
  void drawing(const RecordedDrawing& drawing);

  /// Appends the chunk with all collected data to `out`, and starts the next chunk at its end.
  void pack(const Packer& packer, Bytes& out);

 private:
  /// Items of a list as bytes, and their number.
  struct List {
    Bytes bytes;
    std::uint64_t count = 0;
    void clear() {
      bytes.clear();
      count = 0;
    }
  };

  void writeHead(Bytes& out) const;
  void check(const WorldState& world);
  void sample(const WorldState& world);
  void putSection(Section section, BytesView content, const Packer& packer);
  void startNext();

  RecordingHeader header_;
  std::size_t robots_, balls_;
  Tick first_tick_ = 0;
  int ticks_ = 0;
  std::int64_t plays_before_ = 0, plays_ = 0;
  std::vector<std::uint8_t> present_at_start_, present_;
  /// Bodies on the field in the present play, in the order of the world.
  std::vector<std::uint16_t> on_field_;
  Columns commands_, samples_;
  Bytes exact_commands_;  ///< commands of robots when they are not multiples of a step
  Bytes hashes_, checks_, runs_;
  bool run_value_ = true;
  std::uint64_t run_length_ = 0;
  Bytes play_list_;
  List events_, drawings_;
  Bytes table_, body_;                                     ///< reused when chunks are packed
  std::array<std::size_t, kSectionNames.size()> sizes_{};  ///< packed sizes of the sections [bytes]
};

/// Reads only the head of a chunk. The error describes what is wrong.
tl::expected<ChunkHead, std::string> readChunkHead(BytesView payload, const RecordingHeader& header);
/// Reads the whole chunk. The error describes what is wrong.
tl::expected<RecordedChunk, std::string> readChunk(BytesView payload, const RecordingHeader& header);

/// The packed bytes of each section; all empty for a broken chunk.
std::array<BytesView, kSectionNames.size()> sectionsOf(BytesView payload, const RecordingHeader& header);

/// Unpacked size of a chunk's plays, events and drawings, as its data claims [bytes]; 0 for a broken chunk.
std::uint64_t listBytes(BytesView payload, const RecordingHeader& header);

}  // namespace fulbito
