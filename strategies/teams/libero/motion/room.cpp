#include "strategies/teams/libero/motion/room.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/motion/motion.hpp"
#include "strategies/teams/libero/motion/roll.hpp"

namespace fulbito::libero {
namespace {

/// [m] bodies with a smaller gap count as touching.
double touchGap(const Pitch& pitch) { return pitch.tuning.clearance / 2; }

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

/// Robots on the field.
struct Crowd {
  std::array<const RobotState*, 2 * kMaxTeamSize> robots{};
  std::size_t count = 0;

  void add(const RobotState& robot) { robots[count++] = &robot; }
};

/// A body as seen from one robot that must not touch it: the opponents' keeper, or a mate.
struct Body {
  const Picture& picture;
  const RobotState& self;
  const RobotState& other;
  const Pitch& pitch = picture.pitch;
  Roll start{pitch, self};
  Vec2 faced = math::unit(other.pose.heading);

  double gap() const { return gapAfter(start, 0); }
  /// The gap [m] after `ticks`, in which the other keeps its velocity.
  double gapAfter(const Roll& roll, int ticks) const {
    const Vec2 there = other.pose.position + other.velocity * (ticks * pitch.tick);
    return gapOf(pitch.robot_half, there - roll.place, roll.face, faced);
  }

  /// Whether the robot can stop in front of the other after it has begun `twist`.
  bool allows(Twist twist) const {
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

  /// Whether the `gap` after `ticks` cannot become too small in `more` ticks in which the robot brakes.
  bool staysApart(const Roll& roll, int ticks, int more, double gap) const {
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

  /// The gap [m] to the other, summed over the ticks of a twist with the walls in the way: the sooner the
  /// robot leaves, the greater. Gaps above the ball's radius count as that; otherwise arcs that rub along the
  /// other but end farther away would win. It stops early where the sum cannot reach `enough`.
  double gapsBy(Twist twist, double enough, const Crowd& thirds) const {
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

  /// All robots but the two.
  Crowd thirds() const {
    Crowd crowd;
    for (int i = 0; i < picture.seen.team_size; ++i) {
      const RobotState &mate = picture.own(i), &opponent = picture.opponent(i);
      if (picture.ownPresent(i) && &mate != &self && &mate != &other) crowd.add(mate);
      if (picture.opponentPresent(i) && &opponent != &other) crowd.add(opponent);
    }
    return crowd;
  }

  /// Whether a third robot stops the robot that comes from `before`.
  bool isBlocked(Vec2 before, const Roll& roll, const Crowd& thirds) const {
    for (std::size_t i = 0; i < thirds.count; ++i) {
      const Pose2& third = thirds.robots[i]->pose;
      const Vec2 rel = third.position - roll.place;
      if (squaredNorm(rel) > pitch.bodies * pitch.bodies || dot(rel, roll.place - before) <= 0.0) continue;
      if (gapOf(pitch.robot_half, rel, roll.face, math::unit(third.heading)) < 0.0) return true;
    }
    return false;
  }

  /// `p` moved to where a body with the direction `face` fits between the walls, also in the opponents' goal.
  /// A wall pushes a turning robot off, perhaps into the other.
  Vec2 walled(Vec2 p, Vec2 face) const {
    const double half = reach(pitch.robot_half, face, {1.0, 0.0});
    const double post = pitch.goal_half - half;
    const bool in_mouth = p.x > pitch.half_length - half &&
                          std::abs(p.y) < pitch.goal_half - pitch.robot_half + pitch.tuning.body_gap;
    return in_mouth ? Vec2{p.x, std::clamp(p.y, -post, post)} : insideWalls(pitch.field, p, half);
  }

  /// The command that brings the robot off the other soonest, with either end, turning or not.
  RobotCommand away() const {
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

  /// The heading [rad] along the other, a little off it, in the sense of `wanted`.
  double slideHeading(Twist wanted) const {
    const Vec2 off = unitOr(self.pose.position - other.pose.position, {-1.0, 0.0});
    // A robot that only turns goes the way that it faces, so that both hands are alike.
    const Vec2 going = start.face * (std::abs(wanted.linear) > 1e-9 ? wanted.linear : 1.0);
    const double hand = dot(going, perp(off)) >= 0.0 ? 1.0 : -1.0;
    return math::angleOf(perp(off) * hand + off * 2 * pitch.tuning.slant);
  }

  /// Whether `wanted` is possible without its turn. Between a wanted turn and the slide's, which change from
  /// tick to tick, a robot would turn to and fro and never move: turns go first.
  bool goesStraight(Twist wanted) const {
    return std::abs(wanted.linear) > pitch.tuning.lies && allows({wanted.linear, 0.0});
  }

  /// The possible command nearest to `wanted` that keeps off the other.
  RobotCommand kept(Twist wanted) const {
    const Twist slide = alongHeading(pitch, self, slideHeading(wanted), pitch.speed);
    if (goesStraight(wanted)) return RobotCommand::byTwist({wanted.linear, 0.0});
    if (allows(slide)) return RobotCommand::byTwist(slide);
    if (allows({0.0, slide.angular})) return RobotCommand::byTwist({0.0, slide.angular});
    return away();
  }
};

/// Whether the opponent is in its own area or enters it before a robot could turn away: such opponents count
/// as keepers.
bool keeps(const Picture& picture, int opponent) {
  const RobotState& other = picture.opponent(opponent);
  return isInArea(picture.pitch.field, other.pose.position, false) ||
         isInArea(picture.pitch.field, other.pose.position + other.velocity * picture.pitch.turn_time, false);
}

/// Whether the two cannot meet before the robot rests, at any heading.
bool isFar(const Pitch& pitch, const RobotState& self, const RobotState& keeper) {
  const double away = squaredNorm(keeper.pose.position - self.pose.position);
  const double near = 4 * pitch.bodies;  // no robot has time to come from farther
  if (away > near * near) return true;
  const double ways =
      mostWay(pitch, norm(self.velocity)) + norm(keeper.velocity) * (pitch.ticks_to_rest * pitch.tick);
  const double apart = ways + pitch.bodies + 2 * pitch.tuning.body_gap;
  return away > apart * apart;
}

/// Whether the circles around the two are too far apart for a touch.
bool isApart(const Pitch& pitch, const RobotState& self, const RobotState& mate) {
  const double near = pitch.bodies + 2 * touchGap(pitch);
  return squaredNorm(mate.pose.position - self.pose.position) > near * near;
}

/// Whether the ball lies between the two. Then the robot meets the keeper at the ball, which is allowed.
bool ballBetween(const Picture& picture, const RobotState& self, const RobotState& keeper) {
  const Vec2 way = keeper.pose.position - self.pose.position;
  const Vec2 ball = intoFrame(unitOr(way, {1.0, 0.0}), picture.seen.ball.position - self.pose.position);
  return ball.x > 0.0 && ball.x < norm(way) && std::abs(ball.y) < picture.pitch.ball_radius;
}

/// Whether the robot that drives `twist` is at the ball in half the time in which a contact with the keeper
/// becomes a foul, or of a quarter turn. Then it disputes the ball.
bool reachesBall(const Picture& picture, const RobotState& self, Twist twist) {
  const Pitch& pitch = picture.pitch;
  const BallState& ball = picture.ball.now();
  const double time = std::min(pitch.charge_time / 2, pitch.turn_time);
  const double far = mostWay(pitch, norm(self.velocity)) + norm(ball.velocity) * time + 2 * pitch.touch;
  if (squaredNorm(ball.position - self.pose.position) > far * far) return false;
  Roll roll(pitch, self);
  RobotState there = self;
  const int ticks = static_cast<int>(std::lround(time / pitch.tick));
  for (int i = 1; i <= ticks; ++i) {
    roll.drive(twist);
    there.pose = {roll.place, math::angleOf(roll.face)};
    if (atBall(pitch, there, ball.position + ball.velocity * (i * pitch.tick))) return true;
  }
  return false;
}

/// Whether the robot gives way to its mate. A robot at the ball stays there, since opponents would take it.
/// Otherwise each gives way to the keeper, then to the striker, and among supports to the one of smaller
/// rank. A keeper out of its goal leaves the ball to a mate.
bool yields(const Picture& picture, int robot, int mate) {
  const auto at_ball = [&](int i) { return i != picture.keeper && picture.disputes(i); };
  if (at_ball(robot) != at_ball(mate)) {
    if (robot != picture.keeper) return at_ball(mate);
    return std::abs(picture.own(robot).pose.position.y) > picture.pitch.goal_half + picture.pitch.robot_half;
  }
  const auto order = [&](int i) {
    return i == picture.keeper ? -2 : i == picture.striker ? -1 : picture.rank[static_cast<std::size_t>(i)];
  };
  return order(robot) > order(mate);
}

}  // namespace

bool atBall(const Pitch& pitch, const RobotState& robot, Vec2 ball) {
  const Vec2 way = ball - robot.pose.position;
  const double farthest = pitch.touch + touchGap(pitch);
  if (squaredNorm(way) > farthest * farthest) return false;
  const Vec2 local = intoFrame(math::unit(robot.pose.heading), way);
  const Vec2 outside{std::max(0.0, std::abs(local.x) - pitch.robot_half),
                     std::max(0.0, std::abs(local.y) - pitch.robot_half)};
  return norm(outside) < pitch.ball_radius + touchGap(pitch);
}

std::optional<RobotCommand> clearOfKeeper(const Picture& picture, int robot, Twist wanted,
                                          SlideMemory& slide) {
  slide.left -= picture.seen.dt;
  const RobotState& self = picture.own(robot);
  if (picture.disputes(robot) || reachesBall(picture, self, wanted)) return std::nullopt;
  const Pitch& pitch = picture.pitch;
  const bool slides = slide.left > 0.0;
  if (slides) wanted = alongHeading(pitch, self, slide.heading, pitch.speed);
  std::optional<RobotCommand> kept;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    const RobotState& other = picture.opponent(i);
    if (!picture.opponentPresent(i) || isFar(pitch, self, other) || !keeps(picture, i)) continue;
    if (ballBetween(picture, self, other)) continue;
    const Body body{picture, self, other};
    // One that it touches comes before one that it comes near.
    if (body.gap() < touchGap(pitch)) return body.away();
    if (kept || body.allows(wanted)) continue;
    if (slides && body.allows({0.0, wanted.angular})) {
      kept = RobotCommand::byTwist({0.0, wanted.angular});
      continue;
    }
    kept = body.kept(wanted);
    if (!body.goesStraight(wanted)) slide = {pitch.turn_time, body.slideHeading(wanted)};
  }
  return kept || !slides ? kept : RobotCommand::byTwist(wanted);
}

std::optional<RobotCommand> clearOfMates(const Picture& picture, int robot, Twist wanted,
                                         YieldMemory& memory) {
  memory.left -= picture.seen.dt;
  if (memory.left > 0.0) return memory.command;
  const RobotState& self = picture.own(robot);
  const double held = memory.touching;
  // It fades instead of ending at once, since a noisy sight parts robots that touch.
  memory.touching = std::max(0.0, held - picture.seen.dt);
  std::optional<RobotCommand> kept;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (i == robot || !picture.ownPresent(i)) continue;
    const RobotState& mate = picture.own(i);
    if (isFar(picture.pitch, self, mate)) continue;
    const bool first = !yields(picture, robot, i);
    if (first && isApart(picture.pitch, self, mate)) continue;
    const Body body{picture, self, mate};
    const bool touches = body.gap() < touchGap(picture.pitch);
    if (touches) memory.touching = held + picture.seen.dt;
    if (touches && (!first || held > 2 * picture.pitch.turn_time)) {
      memory = {picture.pitch.turn_time, held, body.away()};
      return memory.command;
    }
    if (!kept && !touches && !first && !body.allows(wanted)) kept = body.kept(wanted);
  }
  return kept;
}

}  // namespace fulbito::libero
