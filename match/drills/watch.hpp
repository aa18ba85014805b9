#pragma once

#include "fulbito/match.hpp"
#include "match/drills/drill.hpp"
#include "match/drills/opponents.hpp"
#include "match/drills/start.hpp"

namespace fulbito {

/// Judges one trial from the true world, in the tested team's frame.
class DrillWatch final : public MatchObserver {
 public:
  DrillWatch(const Drill& drill, const DrillScene& scene, const FieldGeometry& field,
             const RobotPreset& robot, const ExerciseLog& log);

  void onPlayStart(const PlayStart& start) override;
  void onTick(const MatchTick& tick) override;

  /// Whether the trial has its final verdict.
  bool done() const { return done_; }
  /// [m] where the ball was at the start, in the tested team's frame.
  Vec2 ballStart() const { return ball_start_; }
  /// Whether it is a success, which stays: the trial may go on for what else is measured.
  bool succeeded() const { return trial_.success; }
  /// Whether anything but the end of its time ended it.
  bool decided() const { return done_ && !expired_; }
  /// [s] since the signal; negative before it.
  double elapsed() const { return elapsed_; }
  /// [s] after which a trial without a success ends.
  double duration() const { return duration_; }
  /// The result; `ideal` is the lower bound of the time [s], for the excess.
  DrillTrial trial(double ideal) const;

 private:
  struct Now {
    double time = 0.0;  ///< [s] since the signal; negative before
    BallState ball;
    RobotState robot;       ///< the tested team's first robot
    bool touched = false;   ///< the tested team touched the ball in this tick
    bool by_first = false;  ///< its first robot did
    int walls = 0;          ///< contacts of the ball with walls that began in this tick
  };
  Now look(const MatchTick& tick);
  bool holds(const DrillEnd& end, const Now& now) const;
  bool any(const std::vector<DrillEnd>& ends, const Now& now) const;
  void judgePlay(const Now& now);
  void judgeTask(const Now& now);
  void judgeStay(const Now& now, bool inside);
  void judgeTouch(const Now& now);
  void judgePush(const Now& now);
  void judgePrediction(const Now& now);
  void follow(const Now& now);
  void succeed(double time);
  void finish();
  bool alignedWith(const RobotState& robot, double heading, bool either_end) const;
  void hear(const MatchTick& tick);

  const Drill& drill_;
  const DrillScene& scene_;
  const DrillStart& start_;
  const FieldGeometry& field_;
  const RobotPreset& robot_;
  const ExerciseLog& log_;
  double dt_ = 1.0 / 60.0;
  Tick signal_ = 0;  ///< tick of the signal, from which time counts
  double duration_ = 0.0;
  double elapsed_ = 0.0;
  bool begun_ = false;
  bool done_ = false;
  bool own_touch_last_ = false;
  int goal_ = 0;          ///< 1: in the opponents' goal, -1: in the own
  bool touched_ = false;  ///< the tested team has touched the ball
  bool met_ = false;      ///< any robot has touched the ball
  bool expired_ = false;  ///< its time ended it
  bool failed_ = false;   ///< a condition of failure was met
  bool at_wall_ = false;  ///< the ball pressed on a wall in the last tick
  int bounces_ = 0;
  double inside_since_ = -1.0;
  double drift_ = 0.0;
  RobotState before_;  ///< the first robot one tick ago
  Vec2 ball_start_;
  DrillTrial trial_;
};

}  // namespace fulbito
