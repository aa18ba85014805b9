#pragma once

#include "strategies/teams/libero/attack/aim.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// What a robot that presses remembers between ticks.
struct PressMemory {
  double jammed = 0.0;    ///< [s] time that robot and ball have pressed on something without motion
  bool slipping = false;  ///< whether the robot lets a pinched ball slip out
};

/// The wanted point [m] of the first touch. In five-a-side matches a free ball is met on its inner side.
/// There it slips out between the two robots toward the side wall, away from the own goal.
Vec2 firstTouch(const Picture& picture);

/// Measures how long robot and ball have pressed on something without motion.
void watchJam(const Picture& picture, int robot, PressMemory& memory);

/// Drives straight at the ball, since a robot that drives round it would lose it. If two robots push with
/// equal force, nothing moves until one turns its face slightly. Then the ball slips out to the side wall,
/// and the robot that turned first reaches it first.
Twist pressOn(const Picture& picture, int robot, PressMemory& memory);

/// Whether an opponent presses from the other side against the ball that the robot pushes roughly in the
/// wanted direction, in the open field, and neither can push the other away, so that only a spin moves the
/// ball. `rel`: from the robot to the ball [m].
bool isStandOff(const Picture& picture, Vec2 rel, const Aim& aim);

/// Whether nobody keeps their goal at a free ball in their half, where robots cannot shove each other.
bool keeperTookFreeBall(const Picture& picture);

/// Whether a robot behind such a ball touches it, so that a spin throws it across.
bool touchesFreeBall(const Picture& picture, Vec2 rel);

/// Stands with its face at the ball. Robots that brake harder than they speed up are not pushed away, and the
/// ball stays where it is.
Twist holdBall(const Picture& picture, int robot);

}  // namespace fulbito::libero
