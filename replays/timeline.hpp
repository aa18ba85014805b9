#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "replays/recording/recording.hpp"
#include "replays/recording_reader.hpp"

namespace fulbito {

/// The state of a recording at one moment.
struct ReplayMoment {
  double seconds = 0.0;  ///< time in the recording: ticks / control rate, including stoppages
  Tick tick = 0;         ///< the last tick at or before it
  std::size_t play = 0;  ///< index in `ReplayTimeline::plays`
  int period = 1;
  double play_seconds = 0.0;  ///< the period's clock, as the referee counts
  bool playing = false;       ///< false: a restart waits for its signal, or the match has ended
  PerTeam<int> score{};
  Side blue_side = Side::kLeft;
  std::vector<std::optional<Pose2>> bodies;  ///< per body of the header; empty: not on the field
};

/// A goal of a recorded match.
struct ReplayGoal {
  Tick tick = 0;
  double seconds = 0.0;  ///< of the recording
  TeamId team = TeamId::kBlue;
  std::optional<std::uint8_t> robot;  ///< the scoring robot, if one of that team touched the ball last
};

/// A recording of level full, unpacked for viewers: no physics and no decoding while it is shown.
class ReplayTimeline {
 public:
  /// Errors: kBadInput for a recording without samples (for level recipe, expand it first:
  /// replays/verify/expand.hpp) or without a play; as RecordingReader::chunk.
  static Result<ReplayTimeline> read(const RecordingReader& recording);

  const RecordingHeader& header() const { return header_; }
  const std::optional<RecordingResult>& result() const { return result_; }
  Tick ticks() const { return ticks_; }
  double seconds() const { return secondsAt(ticks_); }
  double secondsAt(Tick tick) const { return static_cast<double>(tick) / header_.control_rate; }
  std::span<const RecordedPlay> plays() const { return plays_; }
  std::span<const RecordedEvent> events() const { return events_; }
  std::span<const RecordedSample> samples() const { return samples_; }
  std::span<const RecordedDrawing> drawings() const { return drawings_; }

  /// The moment at a time [s], clamped to the recording. Poses are interpolated between samples (headings the
  /// short way), but not across the start of a play, where bodies jump.
  ReplayMoment at(double seconds) const;
  /// The same, reusing the memory of `moment`.
  void at(double seconds, ReplayMoment& moment) const;
  /// The teams' drawings for a moment: the latest ones of its play, at most `drawingTicks` old.
  std::span<const RecordedDrawing> drawingsAt(const ReplayMoment& moment) const;
  /// In order of time.
  std::vector<ReplayGoal> goals() const;

 private:
  ReplayTimeline() = default;
  void append(RecordedChunk chunk);
  void countPlay();
  void countGoals();
  std::size_t playAt(Tick tick) const;
  /// The last tick of a play, at which the next one begins.
  Tick endOf(std::size_t play) const;
  void place(double ticks, ReplayMoment& moment) const;
  PerTeam<int> scoreAt(const ReplayMoment& moment) const;

  RecordingHeader header_;
  std::optional<RecordingResult> result_;
  Tick ticks_ = 0;
  std::vector<RecordedPlay> plays_;
  std::vector<RecordedEvent> events_;
  std::vector<RecordedSample> samples_;
  std::vector<RecordedDrawing> drawings_;
  std::vector<PerTeam<int>> goals_until_;  ///< in the first 0, 1, 2 ... events
  std::vector<std::uint8_t> playing_;      ///< after each tick, from tick 1 on
  std::vector<std::uint8_t> begun_;        ///< per play: whether it started without a signal
  std::vector<std::int32_t> clock_ticks_;  ///< ticks of play up to each tick, from tick 0 on
};

}  // namespace fulbito
