#pragma once

#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "fulbito/detail/state_hash.hpp"
#include "fulbito/recording.hpp"
#include "replays/verify/resimulate.hpp"

namespace fulbito {

/// Writes the visited plays to a new recording, and compares them with the recorded ones. Stops at the first
/// difference.
class PlayCopier final : public ReplayVisitor {
 public:
  explicit PlayCopier(RecordingWriter writer) : writer_(std::move(writer)) {}

  void chunkBegins(const RecordedChunk& chunk) override;
  bool playBegins(const ReplayedPlay& play) override;
  bool ticked(const ReplayedTick& tick) override;

  std::int64_t plays() const { return plays_; }
  Tick ticks() const { return writer_.tick(); }
  /// First tick of the recording whose state differs from the recorded one, if any.
  const std::optional<Tick>& differs() const { return differs_; }
  /// Writes the remaining data and the result. Sets the ticks and the hash of the result.
  Result<void> finish(RecordingResult result);

 private:
  /// Writes the events and drawings up to this tick of the original recording.
  void pass(Tick until);

  RecordingWriter writer_;
  std::map<Tick, std::vector<RecordedEvent>> events_;  ///< by the tick after which each is written
  std::deque<RecordedDrawing> drawings_;
  StateHash hash_;
  std::int64_t plays_ = 0;
  Tick shift_ = 0;  ///< tick of the copy minus tick of the original
  std::optional<Tick> differs_;
};

}  // namespace fulbito
