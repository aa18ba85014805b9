#pragma once

#include <memory>

#include "match/drills/trials.hpp"
#include "match/drills/watch.hpp"

namespace fulbito {

/// A trial of a drill: the seed and the number in it. The command plays the numbers from 0 of one seed.
struct DrillTrialNumber {
  std::uint64_t seed = kDefaultMatchSeed;
  int index = 0;
};

/// One trial that its caller advances. It is not moved, since the watch and the teams know its parts.
class DrillTrialRun {
 public:
  /// Draws the scene and creates the match. `run` and `drill` must outlive the trial.
  /// Errors: of teams and of starts that cannot be placed.
  static Result<std::unique_ptr<DrillTrialRun>> create(const DrillRun& run, const Drill& drill,
                                                       const MatchConfig& base, DrillTrialNumber number);
  DrillTrialRun(const DrillTrialRun&) = delete;
  DrillTrialRun& operator=(const DrillTrialRun&) = delete;

  /// Plays one control tick; false once the trial is over.
  bool step() { return !watch_.done() && match_->step(); }
  /// Goes through one phase of the match, for a caller between observation and decision; false once the trial
  /// is over.
  bool advance();
  /// Whether the trial has its verdict, or the match cannot go on.
  bool over() const { return watch_.done() || match_->phase() == MatchPhase::kEnded; }
  /// The verdict. Errors: why the match was abandoned.
  Result<DrillTrial> result() const;

  Match& match() { return *match_; }
  const Match& match() const { return *match_; }
  const DrillScene& scene() const { return scene_; }
  const DrillStart& start() const { return start_; }
  /// [s] after which a trial without a success ends.
  double duration() const { return watch_.duration(); }

 private:
  DrillTrialRun(const DrillRun& run, const Drill& drill, const MatchConfig& base, const DrillScene& scene);
  Result<void> seatTeams(const DrillRun& run);

  const Drill& drill_;
  const DrillScene scene_;
  const DrillStart& start_;
  MatchConfig config_;
  ExerciseLog log_;
  DrillWatch watch_;
  std::optional<Match> match_;
};

}  // namespace fulbito
