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
  /// [s] Lower bound of the time of the task; 0 if there is none.
  double ideal() const { return ideal_; }

  Match& match() { return *match_; }
  const Match& match() const { return *match_; }
  const DrillScene& scene() const { return scene_; }
  const DrillStart& start() const { return start_; }
  const Drill& drill() const { return drill_; }
  /// What the trial's judge knows so far.
  const DrillWatch& watch() const { return watch_; }

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
  double ideal_ = 0.0;
};

}  // namespace fulbito
