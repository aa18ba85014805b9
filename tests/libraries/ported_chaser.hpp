#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "fulbito/team.hpp"

namespace fulbito::test {

/// The built-in team `chaser` by `fulbito/team.hpp` alone: every robot drives straight at the ball with
/// whichever end is nearer, and backs off from a wall at which it has stood for a while.
class PortedChaser final : public team::Team {
 public:
  PortedChaser() : Team("ported-chaser", "1.0", "all robots drive straight at the ball") {}

  void begin(const team::Info&) override { unsticking_.fill({}); }

  team::Commands decide(const team::Observation& seen) override {
    team::Commands commands;
    for (int i = 0; i < seen.team_size; ++i) {
      const team::Robot& robot = seen.own[static_cast<std::size_t>(i)];
      if (!robot.present) continue;
      const bool at_wall = wallClearance(robot.position) < info().robot.circumradius() + 0.02;
      const auto free =
          unsticking_[static_cast<std::size_t>(i)].update(robot, seen.playing && at_wall, seen.dt);
      const team::Twist twist = free ? *free : chase(robot, seen.ball.position);
      commands.twist(i, twist.linear, twist.angular);
    }
    return commands;
  }

 private:
  /// Detects a robot that stands although it is meant to move, and backs it off for a moment.
  struct Unsticking {
    std::optional<team::Twist> update(const team::Robot& robot, bool meant, double dt) {
      if (left > 0.0) {
        left -= dt;
        return team::Twist{speed, 3.0};
      }
      const bool still = team::norm(robot.velocity) < 0.03 && std::abs(robot.angular_velocity) < 1.0;
      held = meant && still ? held + dt : 0.0;
      if (held < 0.8) return std::nullopt;
      held = 0.0;
      left = 0.25;
      speed = robot.wheels.left + robot.wheels.right > 0.0 ? -0.5 : 0.5;
      return team::Twist{speed, 3.0};
    }
    double held = 0.0;   // [s] without motion
    double left = 0.0;   // [s] of backing off
    double speed = 0.0;  // [m/s]
  };

  team::Twist chase(const team::Robot& robot, team::Vec2 ball) const {
    constexpr double kPi = 3.14159265358979323846;
    double error = team::wrapAngle(team::angleOf(ball - robot.position) - robot.heading);
    const bool backward = std::abs(error) > kPi / 2;
    if (backward) error = team::wrapAngle(error + kPi);
    const double speed = info().robot.maxSpeed() * std::max(0.0, std::cos(error));
    return {backward ? -speed : speed, 10.0 * error};
  }

  /// Distance [m] to the nearest wall; the field is symmetric.
  double wallClearance(team::Vec2 p) const {
    const team::Field& field = info().field;
    const double x = field.length / 2 - std::abs(p.x), y = field.width / 2 - std::abs(p.y);
    if (field.corner <= 0.0) return std::min(x, y);
    return std::min({x, y, (x + y - field.corner) / std::sqrt(2.0)});
  }

  std::array<Unsticking, team::kMaxTeamSize> unsticking_;
};

}  // namespace fulbito::test
