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

/// What a chunk says of itself before its sections.
struct ChunkHead {
  Tick first_tick = 0;
  int ticks = 0;
  std::int64_t plays_before = 0;
  std::int64_t plays = 0;  ///< that begin in it
  std::uint64_t events = 0, drawings = 0;
  std::vector<std::uint8_t> present;  ///< see RecordedChunk
};

/// One tick of play: the world after its step.
struct TickData {
  Tick tick = 0;  ///< of the recording
  const WorldState* world = nullptr;
  std::span<const WheelSpeeds> commands;  ///< one a robot of the world
  std::uint64_t hash = 0;                 ///< running, after the tick
  bool playing = true;
};

/// Collects a few seconds of a recording and packs them. Its memory is used again for the next chunk.
class ChunkBuilder {
 public:
  explicit ChunkBuilder(const RecordingHeader& header);

  Tick endTick() const { return first_tick_ + ticks_; }
  int ticks() const { return ticks_; }
  /// Whether the next tick or play belongs to the next chunk.
  bool full() const;
  bool empty() const { return ticks_ == 0 && plays_ == 0 && events_.count == 0; }
  std::int64_t plays() const { return plays_before_ + plays_; }

  /// `tick`: of the recording, instead of the play's own.
  void play(const RecordedPlay& play, Tick tick);
  void tick(const TickData& data);
  void event(const RecordedEvent& event);
  void drawing(const RecordedDrawing& drawing);

  /// Appends all that was collected, and starts the next chunk at its end.
  void pack(const Packer& packer, Bytes& out);

 private:
  /// A list of items as bytes, and how many they are.
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
  double heading_step_;
  std::size_t robots_, balls_;
  Tick first_tick_ = 0;
  int ticks_ = 0;
  std::int64_t plays_before_ = 0, plays_ = 0;
  std::vector<std::uint8_t> present_at_start_, present_;
  std::vector<std::uint16_t> on_field_;  ///< bodies of the present play, in the order of the world
  Columns commands_, samples_;
  Bytes exact_commands_;  ///< where commands are no multiples of a step
  Bytes hashes_, checks_, runs_;
  bool run_value_ = true;
  std::uint64_t run_length_ = 0;
  Bytes play_list_;
  List events_, drawings_;
  Bytes table_, body_;                                     ///< of the chunk that is being packed
  std::array<std::size_t, kSectionNames.size()> sizes_{};  ///< of its sections, as packed
};

/// The head of a chunk alone. Errors say what is wrong.
tl::expected<ChunkHead, std::string> readChunkHead(BytesView payload, const RecordingHeader& header);
/// The whole chunk.
tl::expected<RecordedChunk, std::string> readChunk(BytesView payload, const RecordingHeader& header);

/// The packed bytes of each section; all empty for a broken chunk.
std::array<BytesView, kSectionNames.size()> sectionsOf(BytesView payload, const RecordingHeader& header);

/// Bytes that its plays, events and drawings say they unpack to; 0 for a broken one.
std::uint64_t listBytes(BytesView payload, const RecordingHeader& header);

}  // namespace fulbito
