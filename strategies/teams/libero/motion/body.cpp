#include "strategies/teams/libero/motion/body.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/motion/motion.hpp"

namespace fulbito::libero {
namespace {

/// Ticks in which a robot from rest passes another's body.
double passTicks(const Pitch& pitch) { return timeAlong(pitch.pace, 2 * pitch.bodies, 0.0) / pitch.tick; }

/// Half the extent [m] of a square of half size `half` along a side of another square. `a` and `b` are unit
/// vectors along a side of each; all pairs of sides give the same extent.
double reach(double half, Vec2 a, Vec2 b) { return half * (std::abs(dot(a, b)) + std::abs(cross(a, b))); }

/// The gap [m] between two squares along the axis on which they are farthest apart; negative if they overlap.
double gapOf(double half, Vec2 between, Vec2 a, Vec2 b) {
  const double farthest = std::max({std::abs(dot(between, a)), std::abs(cross(between, a)),
                                    std::abs(dot(between, b)), std::abs(cross(between, b))});
  return farthest - half - reach(half, a, b);
}

/// An upper bound of a vector's length, without a root.
double lengthAtMost(Vec2 v) { return std::abs(v.x) + std::abs(v.y); }

}  // namespace

double Body::gapAfter(const Roll& roll, int ticks) const {
  const Vec2 there = other.pose.position + other.velocity * (ticks * pitch.tick);
  return gapOf(pitch.robot_half, there - roll.place, roll.face, faced);
}

bool Body::allows(Twist twist) const {
  Roll roll = start;
  const int tried = ticksTried(pitch, norm(self.velocity)), horizon = tried + pitch.ticks_to_rest;
  for (int i = 1; i < horizon && !(i > tried && roll.rests()); ++i) {
    if (i > tried)
      roll.brake();
    else
      roll.drive(twist);
    const double gap = gapAfter(roll, i);
    if (gap < pitch.tuning.body_gap) return false;
    if (i >= tried && staysApart(roll, i, horizon - 1 - i, gap)) return true;
  }
  return true;
}

bool Body::staysApart(const Roll& roll, int ticks, int more, double gap) const {
  const double time = more * pitch.tick, least = pitch.tuning.body_gap;
  const Vec2 between = other.pose.position + other.velocity * (ticks * pitch.tick) - roll.place;
  const double drives = roll.mostDriven(time), comes = lengthAtMost(other.velocity) * time;
  // At this distance no heading lets two squares touch, and the other only comes nearer if it drives this
  // way.
  const double squares = 2 * std::sqrt(2.0) * pitch.robot_half + 2 * least;
  const double apart = squares + drives + (dot(between, other.velocity) < 0.0 ? comes : 0.0);
  if (squaredNorm(between) > apart * apart) return true;
  const double turn = roll.mostTurned(time) / pitch.half_track, shift = drives + comes;
  return gap - shift - (lengthAtMost(between) + shift + pitch.robot_half) * turn > least;
}

double Body::gapsBy(Twist twist, double enough, const Crowd& thirds) const {
  const double most = pitch.ball_radius;
  Roll roll = start;
  double sum = 0.0;
  const int ticks = static_cast<int>(std::lround(passTicks(pitch)));
  for (int i = 1; i <= ticks && sum + most * (ticks + 1 - i) >= enough; ++i) {
    const Vec2 before = roll.place;
    roll.drive(twist);
    roll.place = walled(roll.place, roll.face);
    if (isBlocked(before, roll, thirds)) roll.place = before;
    sum += std::min(most, gapAfter(roll, i));
  }
  return sum;
}

Crowd Body::thirds() const {
  Crowd crowd;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    const RobotState &mate = picture.own(i), &opponent = picture.opponent(i);
    if (picture.ownPresent(i) && &mate != &self && &mate != &other) crowd.add(mate);
    if (picture.opponentPresent(i) && &opponent != &other) crowd.add(opponent);
  }
  return crowd;
}

bool Body::isBlocked(Vec2 before, const Roll& roll, const Crowd& thirds) const {
  for (std::size_t i = 0; i < thirds.count; ++i) {
    const Pose2& third = thirds.robots[i]->pose;
    const Vec2 rel = third.position - roll.place;
    if (squaredNorm(rel) > pitch.bodies * pitch.bodies || dot(rel, roll.place - before) <= 0.0) continue;
    if (gapOf(pitch.robot_half, rel, roll.face, math::unit(third.heading)) < 0.0) return true;
  }
  return false;
}

Vec2 Body::walled(Vec2 p, Vec2 face) const {
  const double half = reach(pitch.robot_half, face, {1.0, 0.0});
  const double post = pitch.goal_half - half;
  const bool in_mouth = p.x > pitch.half_length - half &&
                        std::abs(p.y) < pitch.goal_half - pitch.robot_half + pitch.tuning.body_gap;
  return in_mouth ? Vec2{p.x, std::clamp(p.y, -post, post)} : insideWalls(pitch.field, p, half);
}

RobotCommand Body::away() const {
  const Vec2 off = self.pose.position - other.pose.position;
  // Of two equal ways round, the one that the robot faces, so that both hands are alike.
  const Vec2 beside = perp(off) * (dot(start.face, perp(off)) >= 0.0 ? 1.0 : -1.0);
  const double v = pitch.speed;
  const Crowd in_the_way = thirds();
  Twist best;
  double most = -1e9;
  for (const Twist twist : {Twist{v, 0.0}, Twist{-v, 0.0}, alongHeading(pitch, self, math::angleOf(off), v),
                            alongHeading(pitch, self, math::angleOf(beside), v),
                            alongHeading(pitch, self, math::angleOf(-beside), v), Twist{}}) {
    const double gaps = gapsBy(twist, most, in_the_way);
    if (gaps > most + 1e-9) most = gaps, best = twist;
  }
  if (best.angular != 0.0) return RobotCommand::byTwist(best);
  // Wheel speeds, because a twist would first stop the robot's rotation.
  return RobotCommand::byWheels({best.linear / pitch.wheel_radius, best.linear / pitch.wheel_radius});
}

double Body::slideHeading(Twist wanted) const {
  const Vec2 off = unitOr(self.pose.position - other.pose.position, {-1.0, 0.0});
  // A robot that only turns goes the way that it faces, so that both hands are alike.
  const Vec2 going = start.face * (std::abs(wanted.linear) > 1e-9 ? wanted.linear : 1.0);
  const double hand = dot(going, perp(off)) >= 0.0 ? 1.0 : -1.0;
  return math::angleOf(perp(off) * hand + off * 2 * pitch.tuning.slant);
}

bool Body::goesStraight(Twist wanted) const {
  return std::abs(wanted.linear) > pitch.tuning.lies && allows({wanted.linear, 0.0});
}

RobotCommand Body::kept(Twist wanted) const {
  const Twist slide = alongHeading(pitch, self, slideHeading(wanted), pitch.speed);
  if (goesStraight(wanted)) return RobotCommand::byTwist({wanted.linear, 0.0});
  if (allows(slide)) return RobotCommand::byTwist(slide);
  if (allows({0.0, slide.angular})) return RobotCommand::byTwist({0.0, slide.angular});
  return away();
}

}  // namespace fulbito::libero
