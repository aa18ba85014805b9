#include "match/drills/watch.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "referee/rules/clauses.hpp"
#include "strategies/interface/team_frame.hpp"

namespace fulbito {
namespace {

// [s] for which a robot must stay within the tolerance to count as arrived
constexpr double kStay = 0.3;
constexpr double kLost = 0.02;       // [m] between body and ball at which a pushed ball is lost
constexpr double kTowardGoal = 0.1;  // [m/s] toward the goal, at least, of a ball that is on target

/// Distance from `p` to the stretch of the goal line between the posts.
double mouthDistance(const FieldGeometry& field, Vec2 p) {
  const double y = std::clamp(p.y, -field.goal_width / 2, field.goal_width / 2);
  return distance(p, {field.length / 2, y});
}

/// How far the point is out of the own goal area; negative inside.
double beyondArea(const FieldGeometry& field, Vec2 p) {
  const double beyond_x = p.x - (-field.length / 2 + field.goal_area_depth);
  const double beyond_y = std::abs(p.y) - field.goal_area_width / 2;
  return std::max(beyond_x, beyond_y);
}

}  // namespace

DrillWatch::DrillWatch(const Drill& drill, const DrillScene& scene, const FieldGeometry& field,
                       const RobotPreset& robot, const ExerciseLog& log)
    : drill_(drill),
      scene_(scene),
      start_(drill.starts[static_cast<std::size_t>(scene.start)]),
      field_(field),
      robot_(robot),
      log_(log),
      ball_start_(scene.placement.ball) {
  duration_ = start_.duration > 0.0 ? start_.duration : drill.duration;
  trial_.start = scene.start;
}

void DrillWatch::onPlayStart(const PlayStart& start) {
  if (begun_) {  // the referee placed the robots again
    const bool to_last = std::any_of(drill_.successes.begin(), drill_.successes.end(),
                                     [](const DrillEnd& end) { return end.what == DrillCondition::kLasted; });
    // A penalty counts as a goal; any other call ends the attack.
    const bool penalty = start.call.kind == RestartKind::kPenalty && start.call.team != scene_.seat;
    if (to_last && !done_ && !penalty && goal_ == 0) succeed(duration_);
    finish();
    return;
  }
  begun_ = true;
  signal_ = start.tick + start.call.delay;
  dt_ = start.world->physics.controlPeriod();
  const Placement placed = seated(start.placement, scene_.seat);
  ball_start_ = placed.ball;
  const auto& first = placed.robots[indexOf(TeamId::kBlue)][0];
  if (first) before_.pose = *first;
  for (const GameEvent& event : start.events) {
    if (event.clause == "placement" && event.team == scene_.seat) ++trial_.illegal;
  }
}

DrillWatch::Now DrillWatch::look(const MatchTick& tick) {
  const Side side =
      scene_.seat == TeamId::kBlue ? tick.referee->blue_side : opposite(tick.referee->blue_side);
  Now now;
  now.time = static_cast<double>(tick.tick - signal_) * dt_;
  now.ball = inTeamFrame(side, tick.world->balls.front());
  for (std::size_t i = 0; i < tick.ids.size(); ++i) {
    if (tick.ids[i] == RobotId{scene_.seat, 0}) now.robot = inTeamFrame(side, tick.world->robots[i]);
  }
  bool at_wall = false;
  for (const ContactEvent& contact : tick.contacts) {
    if (contact.b.kind != BodyKind::kBall) continue;
    at_wall = at_wall || contact.a.kind == BodyKind::kWall;
    if (contact.a.kind != BodyKind::kRobot) continue;
    met_ = true;
    const RobotId id = tick.ids[contact.a.index];
    own_touch_last_ = id.team == scene_.seat;
    now.touched = now.touched || own_touch_last_;
    now.by_first = now.by_first || id == RobotId{scene_.seat, 0};
  }
  // A touch may begin a tick before its first force. So a bounce is a tick with force after one without.
  now.walls = at_wall && !at_wall_ ? 1 : 0;
  at_wall_ = at_wall;
  return now;
}

void DrillWatch::onTick(const MatchTick& tick) {
  if (done_) return;
  const Now now = look(tick);
  elapsed_ = now.time;
  if (log_.asked >= 0) bounces_ += now.walls;
  hear(tick);
  follow(now);
  if (!trial_.success) {
    if (start_.task == DrillTask::kPlay) {
      judgePlay(now);
    } else {
      judgeTask(now);
    }
  }
  before_ = now.robot;
  const double end = trial_.success ? trial_.time + drill_.after : duration_;
  if (!done_ && goal_ == 0 && now.time >= end - dt_ / 2) expired_ = true;
  if (goal_ != 0 || expired_) finish();
}

/// Takes the referee's calls.
void DrillWatch::hear(const MatchTick& tick) {
  for (const GameEvent& event : tick.events) {
    if (event.clause == clause::kGoal && event.team) {
      goal_ = *event.team == scene_.seat ? 1 : -1;
    } else if (event.clause != "kick-off") {
      trial_.stopped_by = event.clause;
    }
  }
}

/// Records the values that all drills measure.
void DrillWatch::follow(const Now& now) {
  touched_ = touched_ || now.touched;
  if (goal_ > 0) trial_.on_target = true;
  if (goal_ < 0) {
    trial_.conceded = true;
    trial_.own_goal = own_touch_last_;
  }
  const double to_line = field_.length / 2 - now.ball.position.x;
  if (touched_ && !now.touched && now.ball.velocity.x > kTowardGoal && to_line > 0.0) {
    const double y = now.ball.position.y + now.ball.velocity.y * to_line / now.ball.velocity.x;
    if (std::abs(y) < field_.goal_width / 2 - robot_.ball.radius) trial_.on_target = true;
  }
}

bool DrillWatch::holds(const DrillEnd& end, const Now& now) const {
  if (now.time > end.within + dt_ / 2) return false;
  const Vec2 ball = now.ball.position;
  switch (end.what) {
    case DrillCondition::kGoal:
      return goal_ > 0;
    case DrillCondition::kConceded:
      return goal_ < 0;
    case DrillCondition::kTouched:
      return now.touched;
    case DrillCondition::kGained:
      return ball.x - ball_start_.x >= end.value;
    case DrillCondition::kDriven:
      return ball_start_.x - ball.x >= end.value;
    case DrillCondition::kOffWall:
      return wallClearance(field_, ball) >= end.value;
    case DrillCondition::kAway:
      return distance(ball, ball_start_) >= end.value;
    case DrillCondition::kNearMouth:
      return mouthDistance(field_, ball) <= end.value;
    case DrillCondition::kCleared:
      return beyondArea(field_, ball) >= end.value;
    case DrillCondition::kLasted:
      return now.time >= duration_ - dt_ / 2;
  }
  return false;
}

bool DrillWatch::any(const std::vector<DrillEnd>& ends, const Now& now) const {
  return std::any_of(ends.begin(), ends.end(), [&](const DrillEnd& end) {
    return (end.start.empty() || end.start == start_.name) && holds(end, now);
  });
}

void DrillWatch::judgePlay(const Now& now) {
  if (any(drill_.failures, now)) {
    failed_ = true;
    finish();
  } else if (any(drill_.successes, now)) {
    succeed(now.time);
  }
}

void DrillWatch::judgeTask(const Now& now) {
  trial_.offered = log_.offered;
  if (!log_.offered) return finish();
  const Exercise& exercise = scene_.exercise;
  const bool near = distance(now.robot.pose.position, exercise.target) <= drill_.tolerance;
  switch (start_.task) {
    case DrillTask::kReachPose:
      return judgeStay(now, near && alignedWith(now.robot, exercise.heading, true));
    case DrillTask::kTurn:
      return judgeStay(now, alignedWith(now.robot, exercise.heading, false));
    case DrillTask::kReachBall:
      return judgeTouch(now);
    case DrillTask::kPush:
      return judgePush(now);
    default:
      return judgePrediction(now);
  }
}

bool DrillWatch::alignedWith(const RobotState& robot, double heading, bool either_end) const {
  double error = std::abs(math::wrapAngle(robot.pose.heading - heading));
  if (either_end) error = std::min(error, math::kPi - error);
  return error <= drill_.heading_tolerance;
}

/// A robot has arrived if it stays; the time is that of its arrival.
void DrillWatch::judgeStay(const Now& now, bool inside) {
  if (!inside) {
    inside_since_ = -1.0;
    return;
  }
  if (inside_since_ < 0.0) inside_since_ = now.time;
  if (now.time - inside_since_ >= kStay - dt_ / 2) succeed(inside_since_);
}

/// Judges the first touch, by the robot's state one tick before.
void DrillWatch::judgeTouch(const Now& now) {
  if (!now.by_first) return;
  const Exercise& exercise = scene_.exercise;
  const Vec2 along = math::unit(exercise.heading);
  const Vec2 to_ball = ball_start_ - before_.pose.position;
  const double aside = std::abs(along.x * to_ball.y - along.y * to_ball.x);
  trial_.error = aside;
  const bool fast = dot(before_.velocity, along) >= exercise.speed;
  if (fast && aside <= drill_.tolerance && alignedWith(before_, exercise.heading, true)) {
    succeed(now.time);
  } else {
    finish();
  }
}

/// The ball must stay at the robot's body over the whole distance.
void DrillWatch::judgePush(const Now& now) {
  const Exercise& exercise = scene_.exercise;
  const Vec2 along = math::unit(exercise.heading);
  const Vec2 moved = now.ball.position - ball_start_;
  drift_ = std::max(drift_, std::abs(along.x * moved.y - along.y * moved.x));
  trial_.error = drift_;
  const math::SinCos sc = math::sinCos(now.robot.pose.heading);
  const Vec2 apart = now.ball.position - now.robot.pose.position;
  const double forward = std::abs(apart.x * sc.cos + apart.y * sc.sin) - robot_.robot.length / 2;
  const double aside = std::abs(apart.y * sc.cos - apart.x * sc.sin) - robot_.robot.width / 2;
  const bool lost = std::max(forward, aside) > robot_.ball.radius + kLost;
  if (touched_ && lost) return finish();
  const double way = distance(exercise.target, ball_start_);
  if (dot(moved, along) < way) return;
  if (drift_ <= drill_.tolerance) {
    succeed(now.time);
  } else {
    finish();
  }
}

void DrillWatch::judgePrediction(const Now& now) {
  const double due = static_cast<double>(log_.asked) * dt_ + scene_.exercise.horizon;
  if (log_.asked < 0 || now.time < due - dt_ / 2) return;
  trial_.error = distance(log_.answer, now.ball.position);
  trial_.counted = !met_ && (start_.bounces < 0 || bounces_ == start_.bounces);
  if (trial_.error <= drill_.tolerance) succeed(now.time);
  finish();
}

void DrillWatch::succeed(double time) {
  trial_.success = true;
  trial_.time = time;
}

void DrillWatch::finish() { done_ = true; }

DrillTrial DrillWatch::trial(double ideal) const {
  DrillTrial trial = trial_;
  trial.ideal = ideal;
  if (start_.decided && !trial.success && !failed_) trial.counted = false;
  if (trial.success) trial.stopped_by = {};
  return trial;
}

}  // namespace fulbito
