// Records a match during play. Component `recorder`.
#pragma once

#include <memory>
#include <string>

#include "fulbito/match.hpp"
#include "fulbito/recording.hpp"

namespace fulbito {

/// The header of a recording of the match.
RecordingHeader recordingHeader(const MatchConfig& config, RecordingLevel level);

/// Records the observed match (docs/recordings.md). `Match::finish` completes the file, however the match
/// ends. If the program dies, the file is readable except for its last few seconds.
class MatchRecorder final : public MatchObserver {
 public:
  /// Opens the file at once, so that errors appear before the match. Errors: as RecordingWriter::create.
  static Result<MatchRecorder> create(const std::string& file, const MatchConfig& config,
                                      RecordingLevel level = RecordingLevel::kFull, bool replace = true);
  /// Records into a sink.
  static Result<MatchRecorder> create(RecordingWriter::Sink sink, const MatchConfig& config,
                                      RecordingLevel level = RecordingLevel::kFull);

  /// Also records drawings of the teams and their navigators, at most `per_second` times per second. Needs
  /// level full; the control rate limits it too. Call before the first step.
  void keepDrawings(int per_second = 10);

  /// Begins a play of the recording.
  void onPlayStart(const PlayStart& start) override;
  /// Adds a tick.
  void onTick(const MatchTick& tick) override;
  /// Adds the event that ends the match early.
  void onAbandoned(const GameEvent& event, const RefereeState&) override { add(event); }
  /// Ends the file.
  void onMatchEnd(const RefereeState& referee, Tick tick) override;
  /// Whether the recording keeps drawings of this tick, see `keepDrawings`.
  bool wantsDrawings(Tick tick) const override { return drawn_every_ > 0 && tick % drawn_every_ == 0; }

  /// After the match: whether all data is in the file. Errors: the first failed write.
  const Result<void>& written() const { return written_; }

 private:
  explicit MatchRecorder(RecordingWriter writer) : writer_(std::move(writer)) {}
  void add(const GameEvent& event);
  void addDrawings(const MatchTick& tick);

  RecordingWriter writer_;   ///< writes to the file or sink
  RecordedEvent event_;      ///< reused, to avoid allocations
  RecordedDrawing drawing_;  ///< the same
  std::uint64_t hash_ = 0;   ///< running hash of the match
  int edits_ = 0;            ///< plays from a user's placement
  Tick drawn_every_ = 0;     ///< ticks between recorded drawings; 0: none
  Result<void> written_;     ///< result of `RecordingWriter::finish`
};

}  // namespace fulbito
