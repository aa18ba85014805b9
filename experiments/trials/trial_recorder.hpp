#pragma once

#include <string>
#include <vector>

#include "experiments/trials/trial.hpp"
#include "navigation/guidance_strokes.hpp"
#include "replays/recording_writer.hpp"

namespace fulbito {

/// Records a trial (docs/recordings.md): one play of a robot and its obstacles.
class TrialRecorder {
 public:
  /// Begins the file. Errors: as RecordingWriter::create.
  static Result<TrialRecorder> create(const std::string& file, const TrialConfig& config,
                                      bool replace = true);
  /// The same into a sink.
  static Result<TrialRecorder> create(RecordingWriter::Sink sink, const TrialConfig& config);

  /// Also keeps what the navigator wants, ten times a second: off unless called.
  void keepGuidance();

  /// The world before its first step.
  void begins(const WorldState& world);
  /// Before a step: what the navigator wants for it.
  void planned(const Guidance& guidance, Vec2 position, Vec2 goal);
  /// After a step; `hash` is of all states so far.
  void ticked(const WorldState& world, WheelSpeeds command, std::uint64_t hash);
  /// Errors: the first of any write.
  Result<void> ends(const TrialResult& result);

 private:
  explicit TrialRecorder(RecordingWriter writer) : writer_(std::move(writer)) {}
  RecordingWriter writer_;
  Tick drawn_every_ = 0;                 ///< ticks between kept guidances; 0: none is kept
  std::vector<GuidanceStroke> strokes_;  ///< of the step to come
};

}  // namespace fulbito
