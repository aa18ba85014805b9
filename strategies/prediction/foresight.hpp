#pragma once

#include <vector>

#include "fulbito/strategy.hpp"
#include "strategies/prediction/ball_prediction.hpp"
#include "strategies/prediction/ball_tracker.hpp"
#include "strategies/prediction/time_to_reach.hpp"

namespace fulbito {

/// Makes an observation that is `MatchInfo::observation_age` old current (docs/skills.md): own robots are
/// rolled forward through the commands that are on their way, opponents go on with a motion that fades over
/// 0.3 s, the ball follows its prediction. With fresh observations it costs nothing.
class Estimator {
 public:
  Estimator() = default;
  /// Errors: none; memory is taken here.
  explicit Estimator(const MatchInfo& info);
  /// Forgets what was sent: play was begun anew.
  void reset();
  /// Whether observations are old at all.
  bool isNeeded() const { return ticks_ > 0; }
  /// `seen` as of now, to be called once a tick; `seen` itself when observations are fresh. `ball` is the
  /// prediction from the ball as seen. The result is valid until the next call.
  const Observation& update(const Observation& seen, const BallPrediction& ball);
  /// Age of observations [s], in whole ticks.
  double age() const { return age_; }

 private:
  using Sent = std::array<WheelSpeeds, kMaxTeamSize>;
  RobotModel robot_;
  int ticks_ = 0;
  double age_ = 0.0;
  double fade_ = 0.0;        ///< [s] of full speed that an opponent's fading motion is worth
  std::vector<Sent> queue_;  ///< ring of the last `ticks_` ticks' commands
  std::size_t oldest_ = 0;
  Observation now_;
};

/// What every team wants to know at each tick, worked out once: the observation made current, the ball's spin
/// and its way. A member of a strategy.
class Foresight {
 public:
  Foresight() = default;
  explicit Foresight(const MatchInfo& info);
  /// Takes in a tick's observation and gives it as of now. Valid until the next call, or as long as `seen`.
  const Observation& update(const Observation& seen);
  /// The ball's way from now on.
  const BallPrediction& ball() const { return prediction_; }
  /// The ball now, with its estimated spin.
  const BallState& ballNow() const { return ball_; }
  const BallCourse& course() const { return course_; }
  const RobotPace& pace() const { return pace_; }
  /// The observation is the first of a new play.
  bool playBegan() const { return play_began_; }

 private:
  BallCourse course_;
  RobotPace pace_;
  Estimator estimator_;
  BallTracker tracker_;
  BallPrediction prediction_;
  BallState ball_;
  double last_since_restart_ = 1e9;
  bool play_began_ = false;
};

}  // namespace fulbito
