// Private header of replays/verify: not installed.
#pragma once

#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "engine/core/base/hash.hpp"
#include "replays/recording_writer.hpp"
#include "replays/verify/resimulate.hpp"

namespace fulbito {

/// Writes the plays that it is shown into a recording of their own, one after the other, while it compares
/// them with what was recorded. Stops at a difference.
class PlayCopier final : public ReplayVisitor {
 public:
  explicit PlayCopier(RecordingWriter writer) : writer_(std::move(writer)) {}

  void chunkBegins(const RecordedChunk& chunk) override;
  bool playBegins(const ReplayedPlay& play) override;
  bool ticked(const ReplayedTick& tick) override;

  std::int64_t plays() const { return plays_; }
  Tick ticks() const { return writer_.tick(); }
  /// Tick of the recording whose state is not the recorded one, if any.
  const std::optional<Tick>& differs() const { return differs_; }
  /// Writes what is left and the end; ticks and hash of `result` are set here.
  Result<void> finish(RecordingResult result);

 private:
  /// Writes what was called and drawn up to this tick of the original.
  void pass(Tick until);

  RecordingWriter writer_;
  std::map<Tick, std::vector<RecordedEvent>> events_;  ///< by the tick after which each is written
  std::deque<RecordedDrawing> drawings_;
  StateHash hash_;
  std::int64_t plays_ = 0;
  Tick shift_ = 0;  ///< from ticks of the original to those of the copy
  std::optional<Tick> differs_;
};

}  // namespace fulbito
