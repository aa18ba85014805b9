#include "strategies/teams/libero/motion/bounds.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/goal_area.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/interface/team_frame.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/motion/roll.hpp"

namespace fulbito::libero {
namespace {

/// A closed goal area, in the frame in which it is the own area.
struct Bound {
  const Pitch& pitch;
  const RobotState& robot;
  double margin;
  AreaShape area = goalAreaOf(pitch.field);

  /// The depth [m] of a point in the area widened by `margin`; negative outside.
  double depth(Vec2 p) const { return margin - distanceTo(area, intoGoalFrame(pitch.field, Side::kLeft, p)); }

  /// Whether a robot that drives `twist` and then brakes stays within the depth `limit` [m].
  bool allows(Twist twist, double limit = 0.0) const {
    Roll roll(pitch, robot);
    for (int i = ticksTried(pitch, norm(robot.velocity)); i > 0; --i) roll.drive(twist);
    for (int left = pitch.ticks_to_rest; left >= 0; --left) {
      const double now = depth(roll.place);
      const double way = roll.mostDriven(left * pitch.tick);  // no longer way is left
      if (now > limit || now + way <= limit) return now <= limit;
      roll.brake();
    }
    return true;
  }

  /// Unit vector of the shortest way out of the area.
  Vec2 outward(Vec2 p) const {
    constexpr double kStep = 1e-4;  // [m] resolution of the slope
    const Vec2 slope{depth({p.x - kStep, p.y}) - depth({p.x + kStep, p.y}),
                     depth({p.x, p.y - kStep}) - depth({p.x, p.y + kStep})};
    return unitOr(slope, {1.0, 0.0});
  }

  Twist along(Vec2 way) const { return alongHeading(pitch, robot, math::angleOf(way), pitch.speed); }

  /// Both wheels at this speed [m/s], without a limit of acceleration.
  RobotCommand straight(double speed) const {
    return RobotCommand::byWheels({speed / pitch.wheel_radius, speed / pitch.wheel_radius});
  }

  /// Leaves the goal mouth. There is no way to either side behind its posts, and a robot along a post must
  /// first move off it.
  RobotCommand leavingMouth() const {
    return RobotCommand::byTwist(along({pitch.robot_corner, -robot.pose.position.y}));
  }

  /// Leaves the area by the quickest of three ways: to the front or to either side.
  RobotCommand leaving() const {
    const Vec2 p = robot.pose.position;
    if (p.x < pitch.robot_corner - pitch.half_length && std::abs(p.y) < pitch.goal_half)
      return leavingMouth();
    Vec2 best{1.0, 0.0};
    double least = 1e9;
    for (const Vec2 way : {Vec2{1.0, 0.0}, Vec2{0.0, 1.0}, Vec2{0.0, -1.0}}) {
      const double room = way.y == 0.0 ? pitch.field.goal_area_depth + pitch.field.goal_area_arc_depth -
                                             pitch.half_length - p.x
                                       : pitch.area_half - way.y * p.y;
      const double time =
          timeToReach(pitch.pace, robot, p + way * std::max(pitch.ball_radius, room + margin));
      if (time < least) least = time, best = way;
    }
    const Vec2 face = math::unit(robot.pose.heading);
    const double ahead = dot(face, best);
    // A twist changes the turn before the speed, so a robot that moves inward must stop first.
    if (dot(robot.velocity, best) < -pitch.creep)
      return straight(std::abs(ahead) > 0.5 ? std::copysign(pitch.speed, ahead) : 0.0);
    return RobotCommand::byTwist(along(best));
  }

  /// Drives along the edge in the sense of `wanted`, with the share `off` of outward motion.
  Twist alongEdge(Twist wanted, double off) const {
    const Vec2 out = outward(robot.pose.position);
    // A robot that only turns drives away from the goal's middle, so that both halves of the field are alike.
    const Vec2 idle = 1e-9 * Vec2{1.0, std::copysign(1.0, robot.pose.position.y)};
    const Vec2 going = math::unit(robot.pose.heading) * wanted.linear + idle;
    const double hand = dot(going, perp(out)) >= 0.0 ? 1.0 : -1.0;
    return along(perp(out) * hand + out * off);
  }

  /// For a robot within the margin but not in the area: `wanted` if it leads outward, otherwise stop and turn
  /// outward.
  RobotCommand fromEdge(Twist wanted) const {
    const Vec2 out = outward(robot.pose.position);
    const double ahead = dot(math::unit(robot.pose.heading), out);
    if (dot(robot.velocity, out) < -pitch.creep) {
      return straight(std::abs(ahead) > 0.5 ? std::copysign(pitch.speed, ahead) : 0.0);
    }
    const bool leads_off = wanted.linear * ahead > pitch.tuning.lies / 2;
    if (leads_off && allows(wanted, depth(robot.pose.position))) return RobotCommand::byTwist(wanted);
    // The sense of `wanted` does not count, since it changes faster than a robot turns.
    return RobotCommand::byTwist(along(out));
  }

  /// The possible command nearest to `wanted` that keeps the robot out.
  RobotCommand kept(Twist wanted) const {
    const double now = depth(robot.pose.position);
    if (now > margin) return leaving();
    if (now > 0.0) return fromEdge(wanted);
    if (now + mostWay(pitch, norm(robot.velocity)) < 0.0) return RobotCommand::byTwist(wanted);
    if (allows(wanted)) return RobotCommand::byTwist(wanted);
    const Twist slide = alongEdge(wanted, pitch.tuning.slant);
    if (allows(slide)) return RobotCommand::byTwist(slide);
    if (allows({0.0, slide.angular})) return RobotCommand::byTwist({0.0, slide.angular});
    return straight(0.0);
  }
};

/// Whether an opponent drives at the robot, or past it toward the own goal, and would push it into the area.
bool isPressed(const Picture& picture, const RobotState& robot) {
  const double near = picture.tuning.rival_far, comes = picture.tuning.lies;
  const Vec2 goal = picture.pitch.ownGoal();
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (!picture.opponentPresent(i)) continue;
    const RobotState& other = picture.opponent(i);
    const Vec2 rel = robot.pose.position - other.pose.position;
    if (squaredNorm(rel) > near * near) continue;
    const Vec2 home = unitOr(goal - other.pose.position, {});
    if (dot(rel, home) < -picture.pitch.robot_corner) continue;
    if (dot(other.velocity, unitOr(rel, {})) > comes) return true;
    if (dot(other.velocity, home) > comes) return true;
  }
  return false;
}

/// The way [m] that an opponent at full speed knocks a robot that stands: both go on at half that speed, and
/// brake. Robots that cannot shove hardly come to full speed.
double knockedWay(const Pitch& pitch) {
  return pitch.shoves ? pitch.speed * pitch.speed / (8 * pitch.braking) : 0.0;
}

/// The margin [m] at the opponents' area. Any part of the body counts as inside there. A robot comes there
/// beside the striker, which may stop at the edge as well, and one of both must stay outside: each has a
/// margin.
double theirMargin(const Pitch& pitch) { return pitch.robot_corner + 2 * pitch.tuning.area_margin; }

/// Whether the robot rests before it can come to the area at any margin. Most robots are that far away.
bool isFar(const Picture& picture, const RobotState& robot, bool own) {
  const Pitch& pitch = picture.pitch;
  const double own_margin = pitch.tuning.area_margin + knockedWay(pitch) + pitch.around;
  const double margin = std::max(own_margin, theirMargin(pitch));
  const double way = mostWay(pitch, norm(robot.velocity)) + pitch.tuning.clearance;
  return !isNearArea(pitch.field, robot.pose.position, own, margin + way);
}

}  // namespace

RobotCommand keptOut(const Picture& picture, int robot, Closed closed, Twist wanted) {
  const RobotState& self = picture.own(robot);
  const bool own = self.pose.position.x < 0.0;
  if (!(own ? closed.own : closed.theirs) || isFar(picture, self, own)) return RobotCommand::byTwist(wanted);
  if (own) {
    // A defender is inside with more than half of its body. One that is pressed comes no nearer, but it
    // stays: a robot that drove out would let the ball in. One that an opponent drives into must not be
    // knocked in.
    const double least = picture.tuning.area_margin + knockedWay(picture.pitch);
    const double room = -Bound{picture.pitch, self, least}.depth(self.pose.position);
    const double more = isPressed(picture, self) ? std::clamp(room, 0.0, picture.pitch.around) : 0.0;
    return Bound{picture.pitch, self, least + more}.kept(wanted);
  }
  return Bound{picture.pitch, inTeamFrame(Side::kRight, self), theirMargin(picture.pitch)}.kept(wanted);
}

}  // namespace fulbito::libero
