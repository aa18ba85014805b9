#include "referee/trial/trial_referee.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/shapes.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kOwnMotionSpeed = 0.02;    // [m/s] toward the contact point
constexpr double kPushedFor = 0.5;          // [s] a push explains a robot's motion for this long
constexpr double kCurvatureJump = 10.0;     // [1/m] larger changes in one tick count as jumps
constexpr double kCurvatureMinSpeed = 0.1;  // [m/s] slower curvatures are meaningless
constexpr double kRestDistance = 0.01;      // [m]
constexpr double kRestTurn = 0.35;          // [rad] 20 degrees
constexpr double kOutside = -0.01;  // [m] a robot's centre this far outside the contour has left the field

/// Share of the step from `a` to `b` at which the circle around `centre` is entered. 1 if `a` is already
/// inside: then another condition of arrival became true at the end of the step.
double entry(Vec2 a, Vec2 b, Vec2 centre, double radius) {
  const Vec2 d = b - a, f = a - centre;
  const double qa = dot(d, d), qb = dot(f, d), qc = dot(f, f) - radius * radius;
  if (qc <= 0.0) return 1.0;
  const double discriminant = qb * qb - qa * qc;
  if (qa <= 0.0 || discriminant < 0.0) return 1.0;
  return std::clamp((-qb - std::sqrt(discriminant)) / qa, 0.0, 1.0);
}

}  // namespace

TrialReferee::TrialReferee(const Layout& layout, const FieldGeometry& field, const RobotModel& robot,
                           const TrialRules& rules, double dt)
    : layout_(layout), field_(field), contour_(innerContour(field)), model_(robot), rules_(rules), dt_(dt) {
  score_.length_limit = rules.length_limit;
  score_.time_limit = rules.time_limit;
  score_.min_clearance = 1e9;
  last_.pose = layout.start;
  rest_pose_ = layout.start;
}

bool TrialReferee::observe(const WorldState& world, std::span<const ContactEvent> contacts,
                           WheelSpeeds command) {
  const RobotState& robot = world.robots.front();
  ++ticks_;
  judgeContacts(contacts);
  measure(world, command);
  watchProgress(robot);
  bool over = true;
  if (arrived(robot)) {
    score_.outcome = spoiled() ? TrialOutcome::kCollided : TrialOutcome::kReached;
  } else if (!insideField(field_, robot.pose.position, kOutside)) {
    score_.outcome = TrialOutcome::kLeftField;
  } else if (static_cast<double>(ticks_ - rest_tick_) * dt_ >= rules_.stuck_after) {
    score_.outcome = spoiled() ? TrialOutcome::kCollided : TrialOutcome::kStuck;
  } else if (late()) {
    score_.outcome = spoiled() ? TrialOutcome::kCollided : TrialOutcome::kTimedOut;
  } else {
    over = false;
  }
  last_ = robot;
  return over;
}

void TrialReferee::judgeContacts(std::span<const ContactEvent> contacts) {
  for (const ContactEvent& event : contacts) {
    const bool robot_first = event.a == BodyId{BodyKind::kRobot, 0};
    if (!robot_first && !(event.b == BodyId{BodyKind::kRobot, 0})) continue;
    const BodyKind other = robot_first ? event.b.kind : event.a.kind;
    if (other == BodyKind::kBall) continue;
    score_.contact_impulse += event.impulse;
    if (other == BodyKind::kWall) {
      score_.wall_contacts += event.began ? 1 : 0;
    } else {
      judgeObstacleContact(event);
    }
  }
}

void TrialReferee::judgeObstacleContact(const ContactEvent& event) {
  const Vec2 toward = unitOr(event.point - last_.pose.position, {});
  const bool driving = dot(last_.velocity, toward) > kOwnMotionSpeed;
  const bool pushed = static_cast<double>(ticks_ - pushed_tick_) * dt_ <= kPushedFor;
  if (event.began) {
    ++score_.obstacle_contacts;
    score_.own_contacts += driving && !pushed ? 1 : 0;
  }
  if (!driving || pushed) pushed_tick_ = ticks_;
}

void TrialReferee::measure(const WorldState& world, WheelSpeeds command) {
  const RobotState& robot = world.robots.front();
  score_.length += distance(robot.pose.position, last_.pose.position);
  score_.time = static_cast<double>(ticks_) * dt_;
  score_.turning += std::abs(math::wrapAngle(robot.pose.heading - last_.pose.heading));
  const double gap = leastClearance(world);
  score_.min_clearance = std::min(score_.min_clearance, gap);
  clearance_sum_ += gap;

  const double speed = norm(robot.velocity);
  if (speed > kCurvatureMinSpeed) {
    const double curvature = robot.angular_velocity / speed;
    if (last_curvature_ && std::abs(curvature - *last_curvature_) > kCurvatureJump) ++score_.curvature_jumps;
    last_curvature_ = curvature;
  } else {
    last_curvature_.reset();
  }

  if (ticks_ >= 3) {
    const double scale = model_.wheel_radius / (dt_ * dt_);
    const double left = scale * (command.left - 2.0 * last_command_.left + second_last_command_.left);
    const double right = scale * (command.right - 2.0 * last_command_.right + second_last_command_.right);
    jerk_sum_ += (left * left + right * right) / 2.0;
  }
  second_last_command_ = last_command_;
  last_command_ = command;
}

void TrialReferee::watchProgress(const RobotState& robot) {
  const bool moved = distance(robot.pose.position, rest_pose_.position) > kRestDistance;
  const bool turned = std::abs(math::wrapAngle(robot.pose.heading - rest_pose_.heading)) > kRestTurn;
  if (moved || turned) {
    rest_pose_ = robot.pose;
    rest_tick_ = ticks_;
  }
  score_.longest_stuck = std::max(score_.longest_stuck, static_cast<double>(ticks_ - rest_tick_) * dt_);
}

bool TrialReferee::arrived(const RobotState& robot) {
  const Vec2 from = last_.pose.position, to = robot.pose.position;
  // A fast robot may cross the circle within a tick, so check the whole segment.
  const double along =
      std::clamp(dot(layout_.goal - from, to - from) / std::max(squaredNorm(to - from), 1e-18), 0.0, 1.0);
  if (distance(from + (to - from) * along, layout_.goal) > layout_.goal_tolerance) return false;
  if (layout_.goal_heading) {
    const double error = math::wrapAngle(robot.pose.heading - *layout_.goal_heading);
    if (std::abs(error) > layout_.heading_tolerance) return false;
    score_.heading_error = std::abs(error);
  }
  const double share = entry(from, to, layout_.goal, layout_.goal_tolerance);
  score_.time -= (1.0 - share) * dt_;
  score_.length -= (1.0 - share) * distance(from, to);
  score_.arrived = true;
  return true;
}

bool TrialReferee::spoiled() const {
  switch (rules_.forbidden) {
    case ForbiddenContacts::kAll:
      return score_.obstacle_contacts + score_.wall_contacts > 0;
    case ForbiddenContacts::kObstacles:
      return score_.obstacle_contacts > 0;
    case ForbiddenContacts::kOwnMotion:
      return score_.own_contacts > 0;
  }
  return true;
}

double TrialReferee::leastClearance(const WorldState& world) const {
  const Rectangle body = bodyOf(model_, world.robots.front().pose);
  double least = clearance(body, contour_);
  for (std::size_t i = 0; i < layout_.obstacles.size(); ++i) {
    least = std::min(least, clearance(body, layout_.obstacles[i], world.obstacles[i].pose));
  }
  return least;
}

TrialScore TrialReferee::score() const {
  TrialScore score = score_;
  if (ticks_ > 0) score.mean_clearance = clearance_sum_ / ticks_;
  if (ticks_ > 2) score.wheel_jerk = std::sqrt(jerk_sum_ / (ticks_ - 2));
  return score;
}

}  // namespace fulbito
