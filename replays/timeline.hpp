#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "replays/recording/recording.hpp"
#include "replays/recording_reader.hpp"

namespace fulbito {

/// Where everyone is at one moment of a recording.
struct ReplayMoment {
  double seconds = 0.0;  ///< of the recording: ticks / control rate; goes on over restarts
  Tick tick = 0;         ///< the last one at or before it
  std::size_t play = 0;  ///< index in `ReplayTimeline::plays`
  int period = 1;
  double play_seconds = 0.0;  ///< the period's clock, as the referee counts
  bool playing = false;       ///< false: a restart waits for its signal, or all is over
  PerTeam<int> score{};
  Side blue_side = Side::kLeft;
  std::vector<std::optional<Pose2>> bodies;  ///< one a body of the header; empty: not on the field
};

/// A goal of a recorded match.
struct ReplayGoal {
  Tick tick = 0;
  double seconds = 0.0;  ///< of the recording
  TeamId team = TeamId::kBlue;
  std::optional<std::uint8_t> robot;  ///< of the team that scored, where one touched the ball last
};

/// All that a viewer needs of a recording of level full, unpacked: no physics, no decoding while it is shown.
class ReplayTimeline {
 public:
  /// Errors: kBadInput for a recording without samples (level recipe: replays/verify/expand.hpp makes a full
  /// one of it) or without a play; as RecordingReader::chunk.
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

  /// Between samples poses are interpolated, headings the short way, but never over the start of a play: a
  /// body jumps there. A play shows its start from its tick on. Times out of range show the nearest end.
  ReplayMoment at(double seconds) const;
  /// The same into a moment whose memory is used again.
  void at(double seconds, ReplayMoment& moment) const;
  /// What teams drew that belongs to a moment: the last of its play, no older than `drawingTicks`.
  std::span<const RecordedDrawing> drawingsAt(const ReplayMoment& moment) const;
  /// In order of time.
  std::vector<ReplayGoal> goals() const;

 private:
  ReplayTimeline() = default;
  void append(RecordedChunk chunk);
  void countPlay();
  void countGoals();
  std::size_t playAt(Tick tick) const;
  /// The last tick that belongs to a play: there the next one begins.
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
  std::vector<std::uint8_t> begun_;        ///< one a play: whether it needed no signal
  std::vector<std::int32_t> clock_ticks_;  ///< ticks of play up to each tick, from tick 0 on
};

}  // namespace fulbito
