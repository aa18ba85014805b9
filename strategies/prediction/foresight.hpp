#pragma once

#include <vector>

#include "fulbito/strategy.hpp"
#include "strategies/prediction/ball_prediction.hpp"
#include "strategies/prediction/ball_tracker.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/prediction/tracks.hpp"

namespace fulbito {

/// Predicts the present from an observation that is `MatchInfo::observation_age` old (docs/skills.md). Own
/// robots follow the commands since then, opponents continue with a motion that fades over 0.3 s, and the
/// ball follows its prediction. Fresh observations need no work.
class Estimator {
 public:
  Estimator() = default;
  /// Allocates all memory.
  explicit Estimator(const MatchInfo& info);
  /// Forgets the past commands, for the start of a new play.
  void reset();
  /// Whether observations have an age.
  bool isNeeded() const { return ticks_ > 0; }
  /// Returns `seen` predicted to the present, or `seen` itself if observations are fresh. Call it once per
  /// tick. `ball` is the prediction from the observed ball. The result is valid until the next call.
  const Observation& update(const Observation& seen, const BallPrediction& ball);
  /// Age of observations [s], in whole ticks.
  double age() const { return age_; }

 private:
  using Sent = std::array<WheelSpeeds, kMaxTeamSize>;
  RobotModel robot_;
  int ticks_ = 0;
  double age_ = 0.0;
  double fade_ = 0.0;        ///< [s] opponents cover their fading motion in this time at constant speed
  std::vector<Sent> queue_;  ///< ring of the last `ticks_` ticks' commands
  std::size_t oldest_ = 0;
  Observation now_;
};

/// The predictions that each team needs per tick: the present observation, the ball's spin and its path. A
/// strategy has one as a member. Noise and age of observations are taken out as far as the models allow.
class Foresight {
 public:
  Foresight() = default;
  /// `horizon` [s]: for how long `ball` is predicted, longer than observations are old.
  explicit Foresight(const MatchInfo& info, double horizon = BallPrediction::kHorizon);
  /// Takes a tick's observation and returns it as of now. Valid until the next call, or as long as `seen`.
  const Observation& update(const Observation& seen);
  /// Whether observations are noisy or old; otherwise `update` returns them as they are.
  bool isNeeded() const { return tracks_.isNeeded() || estimator_.isNeeded(); }
  /// The ball's path from now on.
  const BallPrediction& ball() const { return prediction_; }
  /// The ball now, with its estimated spin.
  const BallState& ballNow() const { return ball_; }
  /// The constants of the ball's motion.
  const BallCourse& course() const { return course_; }
  /// The speed of the team's robots.
  const RobotPace& pace() const { return pace_; }
  /// Whether the observation is the first of a new play.
  bool playBegan() const { return play_began_; }

 private:
  BallCourse course_;
  RobotPace pace_;
  Tracks tracks_;
  Observation tracked_;
  Estimator estimator_;
  BallTracker tracker_;
  BallPrediction prediction_;
  double horizon_ = BallPrediction::kHorizon;  ///< [s]
  BallState ball_;
  double last_since_restart_ = 1e9;
  bool play_began_ = false;
};

}  // namespace fulbito
