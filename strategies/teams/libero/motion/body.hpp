#pragma once

#include <array>
#include <cstddef>

#include "fulbito/strategy.hpp"
#include "strategies/teams/libero/motion/roll.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// [m] bodies with a smaller gap count as touching.
inline double touchGap(const Pitch& pitch) { return pitch.tuning.clearance / 2; }

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
  /// Whether the robot can stop in front of the other after it has begun `twist`.
  bool allows(Twist twist) const;
  /// Whether `wanted` is possible without its turn. Between a wanted turn and the slide's, which change from
  /// tick to tick, a robot would turn to and fro and never move: turns go first.
  bool goesStraight(Twist wanted) const;
  /// The heading [rad] along the other, a little off it, in the sense of `wanted`.
  double slideHeading(Twist wanted) const;
  /// The possible command nearest to `wanted` that keeps off the other.
  RobotCommand kept(Twist wanted) const;
  /// The command that brings the robot off the other soonest, with either end, turning or not.
  RobotCommand away() const;

 private:
  /// The gap [m] after `ticks`, in which the other keeps its velocity.
  double gapAfter(const Roll& roll, int ticks) const;
  /// Whether the `gap` after `ticks` cannot become too small in `more` ticks in which the robot brakes.
  bool staysApart(const Roll& roll, int ticks, int more, double gap) const;
  /// The gap [m] to the other, summed over the ticks of a twist with the walls in the way: the sooner the
  /// robot leaves, the greater. Gaps above the ball's radius count as that; otherwise arcs that rub along the
  /// other but end farther away would win. It stops early where the sum cannot reach `enough`.
  double gapsBy(Twist twist, double enough, const Crowd& thirds) const;
  /// All robots but the two.
  Crowd thirds() const;
  /// Whether a third robot stops the robot that comes from `before`.
  bool isBlocked(Vec2 before, const Roll& roll, const Crowd& thirds) const;
  /// `p` moved to where a body with the direction `face` fits between the walls, also in the opponents' goal.
  /// A wall pushes a turning robot off, perhaps into the other.
  Vec2 walled(Vec2 p, Vec2 face) const;
};

}  // namespace fulbito::libero
