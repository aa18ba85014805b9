#include "strategies/skills/ball_drive.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

/// The field of headings round one ball.
struct DriveField {
  const FieldGeometry& field;
  const DriveGoal& goal;
  double half_body = 0.0;  ///< [m]
  double circle = 0.0;     ///< [m] radius of the way round the ball
  double side = 0.0;       ///< +1: clockwise round the ball, -1: counter-clockwise, 0: the nearer way

  /// Where a wall leaves no room on one side of the ball, the way round is on the other.
  void chooseSide() {
    const auto open = [&](double sense) {
      return wallClearance(field, goal.ball - perp(goal.direction) * (sense * circle)) > half_body;
    };
    const bool right = open(1.0), left = open(-1.0);
    side = right == left ? 0.0 : right ? 1.0 : -1.0;
  }

  double heading(Vec2 p) const {
    const Vec2 way = goal.ball - p;
    const double gap = norm(way);
    if (gap < 1e-6) return math::angleOf(goal.direction);
    const double toward = math::angleOf(way);
    const double off = math::wrapAngle(toward - math::angleOf(goal.direction));
    // Beside or behind the ball the nearer way is right, whatever the walls.
    const double sense = side != 0.0 && std::abs(off) > math::kPi / 2 ? side : std::copysign(1.0, off);
    const double tangent =
        gap > circle ? math::asin(circle / gap) : math::kPi / 2 + 0.5 * (1.0 - gap / circle);
    const double turn = std::min(goal.bend * std::abs(off), tangent);
    return alongWalls(p, toward + sense * turn);
  }

  /// A heading into a near wall turns along it.
  double alongWalls(Vec2 p, double heading) const {
    constexpr double kAhead = 0.03;  // [m]
    const Vec2 ahead = math::unit(heading);
    if (wallClearance(field, p + ahead * kAhead) > half_body) return heading;
    const Vec2 normal = nearestWallNormal(field, p);
    const double into = -dot(ahead, normal);
    if (into <= 0.0) return heading;
    return math::angleOf(unitOr(ahead + normal * into, perp(normal)));
  }
};

}  // namespace

Twist BallDrive::update(const MatchInfo& info, const RobotState& robot, const DriveGoal& goal) {
  constexpr double kGain = 14.0;      // [1/s] yaw rate per heading error: below 0.4 over a latency of 0.03 s
  constexpr double kProbe = 0.01;     // [m]
  constexpr double kGripShare = 0.8;  // of the lateral grip; the rest is for contacts
  constexpr double kFast = 0.4;       // [m/s] a faster robot turns its leading end round
  const RobotModel& model = info.robot;
  // At a wall the body drives in the lane beside it: turned toward the ball itself, its corner would touch
  // the wall and the ball would slip through.
  DriveGoal lane = goal;
  lane.ball = insideWalls(info.field, goal.ball, model.width / 2 + 0.002);
  DriveField guide{info.field, lane, model.width / 2, model.length / 2 + info.ball.radius + goal.room, 0.0};
  guide.chooseSide();
  const Vec2 p = robot.pose.position;
  const double wanted = guide.heading(p);
  double error = math::wrapAngle(wanted - robot.pose.heading);
  const double speed = dot(robot.velocity, math::unit(robot.pose.heading));
  const double limit = math::kPi / 2 + (std::abs(speed) > kFast ? 0.6 : 0.15);
  const double now_off = backward_ ? std::abs(math::wrapAngle(error + math::kPi)) : std::abs(error);
  if (now_off > limit) backward_ = !backward_;
  if (backward_) error = math::wrapAngle(error + math::kPi);
  const Vec2 ahead = math::unit(robot.pose.heading) * (backward_ ? -1.0 : 1.0);
  const double bend = math::wrapAngle(guide.heading(p + ahead * kProbe) - wanted) / kProbe;
  const double curve = std::clamp(bend, -1.0 / guide.circle, 1.0 / guide.circle);
  const double pull = kGain * error;
  // v (v |curve| + |pull|) is the lateral acceleration.
  const double k = std::abs(curve), grip = kGripShare * model.lateral_grip;
  double v = k > 1e-3 ? (std::sqrt(pull * pull + 4.0 * k * grip) - std::abs(pull)) / (2.0 * k)
                      : grip / std::max(std::abs(pull), 1e-3);
  v = std::min({v, model.maxSpeed(), goal.top_speed}) * std::max(0.0, math::cos(error));
  return {backward_ ? -v : v, v * curve + pull};
}

}  // namespace fulbito
