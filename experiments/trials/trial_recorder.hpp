#pragma once

#include <string>
#include <vector>

#include "fulbito/experiment.hpp"
#include "fulbito/recording.hpp"
#include "navigation/guidance_strokes.hpp"

namespace fulbito {

/// Records a trial as one play of a robot and its obstacles (docs/recordings.md).
class TrialRecorder {
 public:
  /// Creates the file. Errors: as RecordingWriter::create.
  static Result<TrialRecorder> create(const std::string& file, const TrialConfig& config,
                                      bool replace = true);
  /// The same, but writes into a sink.
  static Result<TrialRecorder> create(RecordingWriter::Sink sink, const TrialConfig& config);

  /// Also records the navigator's path or field, ten times per second.
  void keepGuidance();

  /// Records the world before its first step.
  void begins(const WorldState& world);
  /// Must be called before a step, with the navigator's guidance for it.
  void planned(const Guidance& guidance, Vec2 position, Vec2 goal);
  /// Must be called after a step; `hash` is the hash of all states so far.
  void ticked(const WorldState& world, WheelSpeeds command, std::uint64_t hash);
  /// Completes the file. Errors: the first failed write.
  Result<void> ends(const TrialResult& result);

 private:
  explicit TrialRecorder(RecordingWriter writer) : writer_(std::move(writer)) {}
  RecordingWriter writer_;
  Tick drawn_every_ = 0;                 ///< ticks between recorded guidances; 0: none is recorded
  std::vector<GuidanceStroke> strokes_;  ///< guidance of the next step
};

}  // namespace fulbito
