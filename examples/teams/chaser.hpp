// The built-in team `chaser`, written as a team outside the simulator. Every robot drives straight at the
// ball with its nearer end, and backs off from a wall when it has stood there for a while.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fulbito/team.hpp"

class Chaser final : public fulbito::team::Team {
 public:
  Chaser() : Team("chaser", "1.0", "all robots drive straight at the ball") {}

  void begin(const fulbito::team::Info&) override { standing_ = {}; }

  fulbito::team::Commands decide(const fulbito::team::Observation& seen) override {
    fulbito::team::Commands commands;
    for (int i = 0; i < seen.team_size; ++i) {
      const auto number = static_cast<std::size_t>(i);
      const fulbito::team::Robot& robot = seen.own[number];
      if (!robot.present) continue;
      const bool at_wall = wallClearance(robot.position) < info().robot.circumradius() + 0.02;
      const auto free = backOff(standing_[number], robot, seen.playing && at_wall, seen.dt);
      const fulbito::team::Twist twist = free ? *free : chase(robot, seen.ball.position);
      commands.twist(i, twist.linear, twist.angular);
    }
    return commands;
  }

 private:
  /// Time for which a robot has stood still, and remaining time for which it backs off.
  struct Standing {
    double held = 0.0;   // [s]
    double left = 0.0;   // [s]
    double speed = 0.0;  // [m/s]
  };

  fulbito::team::Twist chase(const fulbito::team::Robot& robot, fulbito::team::Vec2 ball) const {
    constexpr double kPi = 3.14159265358979323846;
    using namespace fulbito::team;
    double error = wrapAngle(angleOf(ball - robot.position) - robot.heading);
    const bool backward = std::abs(error) > kPi / 2;
    if (backward) error = wrapAngle(error + kPi);
    const double speed = info().robot.maxSpeed() * std::max(0.0, std::cos(error));
    return {backward ? -speed : speed, 10.0 * error};
  }

  /// Distance [m] to the nearest wall or corner triangle; goals do not count.
  double wallClearance(fulbito::team::Vec2 p) const {
    const auto& field = info().field;
    const double x = std::abs(p.x), y = std::abs(p.y);
    const double nearest = std::min(field.length / 2 - x, field.width / 2 - y);
    if (field.corner <= 0.0) return nearest;
    return std::min(nearest, (field.length / 2 + field.width / 2 - field.corner - x - y) / std::sqrt(2.0));
  }

  static std::optional<fulbito::team::Twist> backOff(Standing& s, const fulbito::team::Robot& robot,
                                                     bool meant, double dt) {
    constexpr double kStill = 0.03, kTurning = 1.0;        // [m/s], [rad/s]
    constexpr double kPatience = 0.8, kBackingOff = 0.25;  // [s]
    constexpr double kSpeed = 0.5, kWiggle = 3.0;          // [m/s], [rad/s]
    if (s.left > 0.0) {
      s.left -= dt;
      return fulbito::team::Twist{s.speed, kWiggle};
    }
    const bool still = norm(robot.velocity) < kStill && std::abs(robot.angular_velocity) < kTurning;
    s.held = meant && still ? s.held + dt : 0.0;
    if (s.held < kPatience) return std::nullopt;
    // Away from the direction in which the wheels push.
    s = {0.0, kBackingOff, robot.wheels.left + robot.wheels.right > 0.0 ? -kSpeed : kSpeed};
    return fulbito::team::Twist{s.speed, kWiggle};
  }

  std::array<Standing, fulbito::team::kMaxTeamSize> standing_;
};
