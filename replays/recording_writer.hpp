#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/base/result.hpp"
#include "replays/recording/recording.hpp"

namespace fulbito {

/// One tick of play as a recorder is told of it.
struct RecordingTick {
  const WorldState* world = nullptr;      ///< after the step; its bodies are those present in the play
  std::span<const WheelSpeeds> commands;  ///< as applied, one a robot of the world
  std::uint64_t hash = 0;                 ///< running hash of all states, this one included
  bool playing = true;                    ///< false while a restart waits for its signal
};

/// Writes a recording while it happens: a chunk every few seconds, so that a file cut anywhere can be read up
/// to its last whole chunk. Equal calls give equal bytes. A failed write is kept until `finish`; what comes
/// after it is dropped, so that nobody's match stops for a full disk.
class RecordingWriter {
 public:
  /// Takes the file's bytes in order.
  using Sink = std::function<Result<void>(std::string_view)>;

  /// Begins the file. One that exists is replaced when the new one is finished, or with `replace` off is an
  /// error. A new one whose disk fills up is left cut after its last whole chunk, and removed where it has
  /// none. Errors: kIo; kUsage for a header out of its ranges and for the file "-".
  static Result<RecordingWriter> create(const std::string& file, const RecordingHeader& header,
                                        bool replace = true);
  /// The same into a sink. Errors: the sink's; kUsage.
  static Result<RecordingWriter> create(Sink sink, const RecordingHeader& header);
  RecordingWriter(RecordingWriter&&) noexcept;
  RecordingWriter& operator=(RecordingWriter&&) noexcept;
  /// Without `finish` the file stays cut after its last whole chunk.
  ~RecordingWriter();

  const RecordingHeader& header() const;
  /// Ticks recorded so far.
  Tick tick() const;

  /// A play begins at the present tick; one must before the first tick. `play.tick` is set here.
  void beginPlay(const RecordedPlay& play);
  /// One more tick. Allocates nothing once warm, but for the end of a chunk.
  void add(const RecordingTick& tick);
  /// @{ Of the present tick or of one shortly before. Drawings are kept at the full level only.
  void add(const RecordedEvent& event);
  void add(const RecordedDrawing& drawing);
  /// @}

  /// Writes what is left, the result and the index. `result.ticks` is set here. Errors: the first of any
  /// write. Later calls do nothing.
  Result<void> finish(const RecordingResult& result);

 private:
  struct Impl;
  explicit RecordingWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
