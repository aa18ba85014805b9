#include "strategies/teams/libero/legal.hpp"

#include <cmath>

#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/attack/press.hpp"
#include "strategies/teams/libero/motion/bounds.hpp"

namespace fulbito::libero {
namespace {

/// The twist that a robot command asks for.
Twist twistOf(const Pitch& pitch, const RobotCommand& command) {
  if (command.kind == RobotCommand::Kind::kTwist) return command.twist;
  const double left = command.wheels.left * pitch.wheel_radius;
  const double right = command.wheels.right * pitch.wheel_radius;
  return {(left + right) / 2, (right - left) / (2 * pitch.half_track)};
}

/// Whether the ball will be in or near the own area by the time a robot has turned round, with a keeper
/// there. Opponents would push a field player that follows it into the area.
bool ballIsKeepers(const Picture& picture) {
  const Pitch& pitch = picture.pitch;
  const Vec2 ball = picture.ball.at(2 * pitch.turn_time);
  return picture.keeper >= 0 && isInArea(pitch.field, ball, true, pitch.front) &&
         std::abs(ball.y) < pitch.area_half;
}

/// Whether the striker is outside the opponents' area and another own robot is inside: a second one inside
/// is a foul.
bool mateIsIn(const Picture& picture) {
  if (isNearArea(picture.pitch.field, picture.own(picture.striker).pose.position, false,
                 picture.pitch.robot_half))
    return false;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (i == picture.striker || !picture.ownPresent(i)) continue;
    if (isNearArea(picture.pitch.field, picture.own(i).pose.position, false,
                   picture.pitch.robot_corner + picture.tuning.clearance / 2))
      return true;
  }
  return false;
}

}  // namespace

RobotCommand legal(const Picture& picture, int robot, Twist wanted, Memory& memory) {
  if (robot == picture.keeper)
    return clearOfMates(picture, robot, wanted, memory.yield).value_or(RobotCommand::byTwist(wanted));
  const Pitch& pitch = picture.pitch;
  // A free ball lies at the area's edge, and a robot that avoids the edge would come late.
  if (robot == picture.striker && picture.disputesFreeBall() && !ballIsKeepers(picture))
    return clearOfKeeper(picture, robot, wanted, memory.slide).value_or(RobotCommand::byTwist(wanted));
  // In five-a-side matches a second attacker in their area gains more than the resulting goal kicks cost.
  const bool theirs = !pitch.isLarge() && (robot != picture.striker || mateIsIn(picture));
  if (!theirs) {
    if (const auto off = clearOfKeeper(picture, robot, wanted, memory.slide)) return *off;
  }
  if (const auto off = clearOfMates(picture, robot, wanted, memory.yield)) wanted = twistOf(pitch, *off);
  const RobotCommand kept = keptOut(picture, robot, {picture.keeper >= 0, theirs}, wanted);
  // A robot that must leave their area must not push the keeper aside.
  if (theirs && isInArea(pitch.field, picture.own(robot).pose.position, false, pitch.robot_corner)) {
    if (const auto off = clearOfKeeper(picture, robot, twistOf(pitch, kept), memory.slide)) return *off;
  }
  return kept;
}

}  // namespace fulbito::libero
