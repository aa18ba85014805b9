#include "strategies/libero_areas.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math.hpp"

namespace fulbito::libero {

bool inOwnArea(const Pitch& pitch, Vec2 p, double margin) {
  const double depth = p.x + pitch.half_length;
  const double y = std::abs(p.y);
  if (depth < pitch.area_depth + margin && y < pitch.area_half + margin) return true;
  return depth < pitch.area_depth + pitch.arc_depth + margin && y < pitch.arc_half + margin;
}

bool inTheirArea(const Pitch& pitch, Vec2 p, double margin) { return inOwnArea(pitch, -p, margin); }

Vec2 outOfOwnArea(const Pitch& pitch, Vec2 p, double margin) {
  if (!inOwnArea(pitch, p, margin)) return p;
  const double arc = std::abs(p.y) < pitch.arc_half + margin ? pitch.arc_depth : 0.0;
  const double front = -pitch.half_length + pitch.area_depth + arc + margin;
  const double side = pitch.area_half + margin;
  if (side - std::abs(p.y) < front - p.x && side < pitch.half_width - pitch.robot_half) {
    return {p.x, std::copysign(side, p.y)};
  }
  return {front, p.y};
}

Vec2 outOfTheirArea(const Pitch& pitch, Vec2 p, double margin) { return -outOfOwnArea(pitch, -p, margin); }

namespace {

constexpr double kBrake = 5.0;         // [m/s^2] reckoned with
constexpr double kOwnMargin = 0.03;    // [m] about our area: a defender is in it with more than half
constexpr double kTheirMargin = 0.06;  // [m] about theirs: an attacker with any part

/// How deep `p` lies in the widened area [m]; negative outside.
double depthIn(const Pitch& pitch, Vec2 p, double margin) {
  const double depth = p.x + pitch.half_length, y = std::abs(p.y);
  const double box = std::min(pitch.area_depth - depth, pitch.area_half - y);
  const double arc = std::min(pitch.area_depth + pitch.arc_depth - depth, pitch.arc_half - y);
  return std::max(box, arc) + margin;
}

/// `keptOut` of our area; theirs is the same turned by half a turn.
bool turnedOff(const Pitch& pitch, const RobotState& robot, double margin, Twist& wanted) {
  const Vec2 place = robot.pose.position;
  if (place.x > -pitch.half_length + 0.45) return false;
  const Vec2 face = math::unit(robot.pose.heading);
  // Where it would stand if it went on for a moment as wanted and then braked.
  const double speed = (dot(robot.velocity, face) + wanted.linear) / 2;
  const Vec2 stop = place + face * (speed * 0.05 + speed * std::abs(speed) / (2 * kBrake));
  const bool inside = inOwnArea(pitch, place, margin);
  if (!inside && !inOwnArea(pitch, stop, margin)) return false;
  // On its way out already, by whatever way.
  if (inside && depthIn(pitch, stop, margin) < depthIn(pitch, place, margin)) return false;
  const Vec2 out = outOfOwnArea(pitch, inside ? place : stop, margin + 0.02);
  if (inside) {
    // Already there: out by the shortest way, unless it is on its way.
    wanted = passThrough(pitch, robot, out + (out - place) * 2.0, pitch.speed);
    return true;
  }
  wanted = restAt(pitch, robot, out, robot.pose.heading);
  return true;
}

RobotState turned(const RobotState& robot) {
  RobotState state = robot;
  state.pose = {-robot.pose.position, math::wrapAngle(robot.pose.heading + math::kPi)};
  state.velocity = -robot.velocity;
  return state;
}

}  // namespace

Twist keptOut(const Pitch& pitch, const RobotState& robot, Closed closed, Twist wanted) {
  if (closed.own) turnedOff(pitch, robot, kOwnMargin, wanted);
  if (closed.theirs && robot.pose.position.x > 0.0) turnedOff(pitch, turned(robot), kTheirMargin, wanted);
  return wanted;
}

}  // namespace fulbito::libero
