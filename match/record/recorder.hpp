#pragma once

#include <memory>
#include <string>

#include "match/play/match_observer.hpp"
#include "replays/recording_writer.hpp"

namespace fulbito {

/// What a recording of the match says at its head.
RecordingHeader recordingHeader(const MatchConfig& config, RecordingLevel level);

/// Records the match that it watches (docs/recordings.md). However the match ends, `Match::finish` leaves a
/// whole file; a program that dies leaves one that can be read up to its last few seconds.
class MatchRecorder final : public MatchObserver {
 public:
  /// Begins the file at once, so that a folder that cannot be written is known before the match.
  /// Errors: as RecordingWriter::create.
  static Result<MatchRecorder> create(const std::string& file, const MatchConfig& config,
                                      RecordingLevel level = RecordingLevel::kFull, bool replace = true);
  /// The same into a sink.
  static Result<MatchRecorder> create(RecordingWriter::Sink sink, const MatchConfig& config,
                                      RecordingLevel level = RecordingLevel::kFull);

  /// Also keeps what the teams and their navigators draw, `per_second` times a second as far as the level and
  /// the control rate allow: off unless called. To be called before the first step.
  void keepDrawings(int per_second = 10);

  void playBegins(const PlayStart& start) override;
  void ticked(const MatchTick& tick) override;
  void abandoned(const GameEvent& event, const RefereeState&) override { add(event); }
  void matchEnds(const RefereeState& referee, Tick tick) override;
  bool wantsDrawings(Tick tick) const override { return drawn_every_ > 0 && tick % drawn_every_ == 0; }

  /// Once the match has ended: whether all of it could be written. Errors: the first of any write.
  const Result<void>& written() const { return written_; }

 private:
  explicit MatchRecorder(RecordingWriter writer) : writer_(std::move(writer)) {}
  void add(const GameEvent& event);
  void addDrawings(const MatchTick& tick);

  RecordingWriter writer_;
  RecordedEvent event_;      ///< reused, so that texts need no new memory
  RecordedDrawing drawing_;  ///< the same
  std::uint64_t hash_ = 0;   ///< running, of the match
  int edits_ = 0;            ///< plays from a user's placement
  Tick drawn_every_ = 0;     ///< ticks between kept drawings; 0: none are kept
  Result<void> written_;
};

}  // namespace fulbito
