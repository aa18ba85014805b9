#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/base/result.hpp"
#include "replays/recording/recording.hpp"

namespace fulbito {

/// One tick of play, for the recording.
struct RecordingTick {
  const WorldState* world = nullptr;      ///< after the step; its bodies are those present in the play
  std::span<const WheelSpeeds> commands;  ///< as applied, one per robot of the world
  std::uint64_t hash = 0;                 ///< running hash of all states, this one included
  bool playing = true;                    ///< false while a restart waits for its signal
};

/// Writes a recording during the match: a chunk every few seconds, so that a file that is cut off can be read
/// up to its last complete chunk. Equal calls give equal bytes. `finish` reports the first failed write;
/// later data are dropped, so a full disk does not stop a match.
class RecordingWriter {
 public:
  /// Receives the file's bytes in order.
  using Sink = std::function<Result<void>(std::string_view)>;

  /// Starts the file. An existing file is replaced when the new one is finished; without `replace` it is an
  /// error. On a full disk, the new file ends after its last complete chunk, or is removed if it has none.
  /// Errors: kIo; kUsage for a header outside its ranges and for the file "-".
  static Result<RecordingWriter> create(const std::string& file, const RecordingHeader& header,
                                        bool replace = true);
  /// The same into a sink. Errors: the sink's; kUsage.
  static Result<RecordingWriter> create(Sink sink, const RecordingHeader& header);
  RecordingWriter(RecordingWriter&&) noexcept;
  RecordingWriter& operator=(RecordingWriter&&) noexcept;
  /// Without `finish`, the file ends after its last complete chunk.
  ~RecordingWriter();

  const RecordingHeader& header() const;
  /// Ticks recorded so far.
  Tick tick() const;

  /// Starts a play at the present tick; required before the first tick. Sets `play.tick`.
  void beginPlay(const RecordedPlay& play);
  /// Adds a tick. Allocates nothing once warm, except at the end of a chunk.
  void add(const RecordingTick& tick);
  /// @{ Adds an event or drawing of a recent tick. Only level full stores drawings.
  void add(const RecordedEvent& event);
  void add(const RecordedDrawing& drawing);
  /// @}

  /// Writes the remaining data, the result and the index. Sets `result.ticks`. Errors: the first failed
  /// write. Later calls do nothing.
  Result<void> finish(const RecordingResult& result);

 private:
  struct Impl;
  explicit RecordingWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
