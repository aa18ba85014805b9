#pragma once

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/situation/pitch.hpp"

namespace fulbito::libero {

inline constexpr double kStands = 1e-9;  ///< [m/s] rounding: below it, braking wheels stand still

/// Ticks for which a robot must be able to go on with a command before it takes it. One that stands tries a
/// few: the first tick moves it so little that any command seems harmless, and it would start and stop
/// forever at the edge of a closed place.
inline int ticksTried(const Pitch& pitch, double speed) {
  return speed > pitch.tuning.lies ? 1 : pitch.ticks_to_start;
}

/// Deceleration [m/s^2] that a robot plans with when it brakes and slides.
inline double slowing(const Pitch& pitch) {
  return pitch.tuning.braking_share * std::min(pitch.braking, pitch.sliding);
}

/// Greatest distance [m] that a robot with `speed` [m/s] covers before it rests, after one tick of any
/// command.
inline double mostWay(const Pitch& pitch, double speed) {
  const double then = speed + pitch.acceleration * pitch.tick;
  return then * (2 * pitch.tick + then / (2 * slowing(pitch)));
}

/// Unit vector at a small `angle` [rad], exact to 1e-7 up to 0.26, which is half of the greatest turn in a
/// tick.
inline Vec2 smallTurn(double angle) {
  const double square = angle * angle;
  return {1.0 - square / 2 * (1.0 - square / 12 * (1.0 - square / 30)),
          angle * (1.0 - square / 6 * (1.0 - square / 20))};
}

/// Predicts a robot's motion under commands, tick by tick.
struct Roll {
  const Pitch& pitch;
  Vec2 place;
  Vec2 face;             ///< unit vector of its heading
  double forward = 0.0;  ///< [m/s]
  double across = 0.0;   ///< [m/s] to the left: sideways slide of a robot that is pushed
  double yaw = 0.0;      ///< [m/s] wheel speed from turning

  Roll(const Pitch& on, const RobotState& robot)
      : pitch(on),
        place(robot.pose.position),
        face(math::unit(robot.pose.heading)),
        yaw(robot.angular_velocity * on.half_track) {
    const Vec2 local = intoFrame(face, robot.velocity);
    forward = local.x;
    across = local.y;
  }

  bool rests() const { return forward == 0.0 && yaw == 0.0 && across == 0.0; }

  /// One tick of a twist. As in the limiter, the acceleration of the wheels goes to turning first.
  void drive(Twist wanted) {
    const double before = forward, yaw_before = yaw, most = pitch.turning * pitch.half_track * pitch.tick;
    const double turn = std::clamp(wanted.angular * pitch.half_track - yaw, -most, most);
    const double change = wanted.linear - forward;
    const double gain = change * forward < 0.0 ? pitch.braking : pitch.acceleration;
    const double rest = (1.0 - std::abs(turn) / most) * gain * pitch.tick;
    yaw = std::clamp(yaw + turn, -pitch.speed, pitch.speed);
    const double room = pitch.speed - std::abs(yaw);
    forward = std::clamp(forward + std::clamp(change, -rest, rest), -room, room);
    move((before + forward) / 2, (yaw_before + yaw) / 2);
  }

  /// One tick in which both wheels brake.
  void brake() {
    const double before = forward, yaw_before = yaw;
    const RimSpeeds rims{forward - yaw, forward + yaw};
    const RimSpeeds most{pitch.motors.limit(), pitch.motors.limit()};
    const RimSpeeds change = pitch.motors.change(rims, pitch.motors.pulls(rims, {}, most));
    forward += (change.left + change.right) / 2;
    yaw += (change.right - change.left) / 2;
    if (std::abs(forward) + std::abs(yaw) < kStands) forward = yaw = 0.0;
    move((before + forward) / 2, (yaw_before + yaw) / 2);
  }

  /// @{ Upper bounds [m] while it brakes for `time` [s]: the way of its centre, and the way of its rims by
  /// turning.
  double mostDriven(double time) const { return std::min(fastest() * time, mostRolled()); }
  double mostTurned(double time) const { return std::min(std::abs(yaw) * time, mostRolled()); }
  /// @}

  /// An upper bound of its speed [m/s] while it brakes.
  double fastest() const { return std::abs(forward) + std::abs(across); }

  /// An upper bound of the way [m] of any of its rims until it rests. Brakes take the speed off the faster
  /// rim first, so a robot that spins keeps its own speed for longer.
  double mostRolled() const {
    const double rims = fastest() + std::abs(yaw);
    return rims * (pitch.tick + rims / (2 * slowing(pitch)));
  }

  void move(double speed, double turning) {
    const double slows = pitch.tuning.braking_share * pitch.sliding * pitch.tick;
    across -= std::clamp(across, -slows, slows);
    const Vec2 half = smallTurn(turning / pitch.half_track * (pitch.tick / 2));
    const Vec2 middle = outOfFrame(face, half);
    place += outOfFrame(middle, {speed, across}) * pitch.tick;
    face = outOfFrame(middle, half);
  }
};

}  // namespace fulbito::libero
