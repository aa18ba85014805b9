#pragma once

#include <memory>
#include <string>

#include "match/match_observer.hpp"
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
                                      RecordingLevel level = RecordingLevel::kFull);
  /// The same into a sink.
  static Result<MatchRecorder> create(RecordingWriter::Sink sink, const MatchConfig& config,
                                      RecordingLevel level = RecordingLevel::kFull);

  void playBegins(const PlayStart& start) override;
  void ticked(const MatchTick& tick) override;
  void matchEnds(const RefereeState& referee, Tick tick) override;

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
  Result<void> written_;
};

}  // namespace fulbito
