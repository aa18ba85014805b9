#include <algorithm>

#include <fmt/format.h>

#include "engine/core/config/schemas.hpp"

namespace fulbito {
namespace {

// A schema binds to a mutable value. Checking writes nothing, so a copy is enough.
template <typename T>
std::optional<Flaw> ownRangeFlaw(T value, const char* table, int index = -1) {
  return rangeFlaw(schemaOf(value), table, index);
}

/// Wheels that do not fit into the body: usually a misplaced decimal point.
std::optional<Flaw> wheelFlaw(const RobotModel& robot) {
  const double longest_wheel = std::max(robot.length, robot.width) / 2, widest = 2 * robot.circumradius();
  if (robot.wheel_radius > longest_wheel) {
    return Flaw{"robot", -1, "wheel_radius",
                fmt::format("= {} must be at most half of the body's longer side, {} m", robot.wheel_radius,
                            longest_wheel)};
  }
  if (robot.axle_track > widest) {
    return Flaw{"robot", -1, "axle_track",
                fmt::format("= {} must be at most the body's diagonal, {:.6g} m", robot.axle_track, widest)};
  }
  return std::nullopt;
}

bool allEqual(const std::vector<Vec2>& path) {
  return std::all_of(path.begin(), path.end(), [&](Vec2 p) { return p == path.front(); });
}

std::optional<Flaw> pathFlaw(const ObstacleSpec& obstacle, int index) {
  if (obstacle.motion != ObstacleMotion::kPath) return std::nullopt;
  const auto flaw = [index](const char* key, std::string text) {
    return Flaw{"obstacle", index, key, std::move(text)};
  };
  const std::vector<Vec2>& path = obstacle.path;
  if (path.size() < 2) return flaw("path", fmt::format("needs at least 2 waypoints, has {}", path.size()));
  if (allEqual(path)) return flaw("path", "needs two different waypoints");
  if (!(obstacle.speed > 0.0)) return flaw("speed", "= 0 must be above 0 for an obstacle on a path");
  if (obstacle.pose.position != path.front())
    return flaw("position", "must be the first waypoint of its path");
  return std::nullopt;
}

constexpr double kThinnest = 1e-3;       // [m] thinnest part of a wall: its corners must not coincide
constexpr double kLeastGoal = 0.01;      // [m]
constexpr double kFinestCommand = 1e-6;  // [rad/s]

/// The key must be 0 (`zero` explains the meaning) or at least `least`.
std::optional<Flaw> tinyFlaw(const char* table, const char* key, double value, double least,
                             const char* zero) {
  if (value == 0.0 || value >= least) return std::nullopt;
  return Flaw{table, -1, key, fmt::format("= {} must be 0 ({}) or at least {}", value, zero, least)};
}

}  // namespace

std::optional<Flaw> findFlaw(const RobotModel& robot) {
  if (auto flaw = ownRangeFlaw(robot, "robot")) return flaw;
  if (auto flaw = wheelFlaw(robot)) return flaw;
  if (robot.spin_slow_speed > 0.0 && !(robot.spin_fast_speed > robot.spin_slow_speed)) {
    return Flaw{
        "robot", -1, "spin_fast_speed",
        fmt::format("= {} must be above spin_slow_speed = {}", robot.spin_fast_speed, robot.spin_slow_speed)};
  }
  return std::nullopt;
}

std::optional<Flaw> findFlaw(const BallModel& ball) { return ownRangeFlaw(ball, "ball"); }

std::optional<Flaw> findFlaw(const PhysicsProfile& physics) {
  if (auto flaw = ownRangeFlaw(physics, "physics")) return flaw;
  return tinyFlaw("physics", "wheel_command_step", physics.wheel_command_step, kFinestCommand, "not rounded");
}

std::optional<Flaw> findFlaw(const FieldGeometry& field) {
  if (auto flaw = ownRangeFlaw(field, "field")) return flaw;
  if (auto flaw = tinyFlaw("field", "goal_width", field.goal_width, kLeastGoal, "no goals")) return flaw;
  if (auto flaw = tinyFlaw("field", "goal_depth", field.goal_depth, kThinnest, "no goal behind the line")) {
    return flaw;
  }
  if (auto flaw = tinyFlaw("field", "corner", field.corner, kThinnest, "square corners")) return flaw;
  const double shorter = std::min(field.length, field.width);
  if (!(2 * field.corner < shorter)) {
    return Flaw{"field", -1, "corner",
                fmt::format("= {} must be below half of the shorter side, {}", field.corner, shorter / 2)};
  }
  if (field.hasGoals() && !(field.goal_width + 2 * field.corner < field.width)) {
    return Flaw{"field", -1, "goal_width",
                fmt::format("= {} must be below the width minus both corners, {}", field.goal_width,
                            field.width - 2 * field.corner)};
  }
  return std::nullopt;
}

std::optional<Flaw> findFlaw(const Layout& layout) {
  Layout head = layout;
  if (auto flaw = rangeFlaw(layoutSchema(head), "layout")) return flaw;
  if (auto flaw = rangeFlaw(startSchema(head), "start")) return flaw;
  if (auto flaw = rangeFlaw(goalSchema(head), "goal")) return flaw;
  if (layout.obstacles.size() > kMaxObstacles) {
    return Flaw{"obstacle", static_cast<int>(kMaxObstacles), "",
                fmt::format("is one too many: a layout may have at most {} obstacles", kMaxObstacles)};
  }
  for (std::size_t i = 0; i < layout.obstacles.size(); ++i) {
    const int index = static_cast<int>(i);
    if (auto flaw = ownRangeFlaw(layout.obstacles[i], "obstacle", index)) return flaw;
    if (auto flaw = pathFlaw(layout.obstacles[i], index)) return flaw;
  }
  return std::nullopt;
}

std::optional<Flaw> findFlaw(const Layout& layout, const FieldGeometry& field) {
  if (auto flaw = findFlaw(layout)) return flaw;
  const auto outside = [&field](Vec2 p) {
    return fmt::format("= [{}, {}] is outside the field '{}'", p.x, p.y, field.name);
  };
  if (!insideField(field, layout.start.position)) {
    return Flaw{"start", -1, "position", outside(layout.start.position)};
  }
  if (!insideField(field, layout.goal)) return Flaw{"goal", -1, "position", outside(layout.goal)};
  for (std::size_t i = 0; i < layout.obstacles.size(); ++i) {
    const Vec2 p = layout.obstacles[i].pose.position;
    if (!insideField(field, p)) return Flaw{"obstacle", static_cast<int>(i), "position", outside(p)};
  }
  return std::nullopt;
}

Result<void> validate(const RobotModel& robot) { return asResult(findFlaw(robot)); }
Result<void> validate(const BallModel& ball) { return asResult(findFlaw(ball)); }
Result<void> validate(const PhysicsProfile& physics) { return asResult(findFlaw(physics)); }
Result<void> validate(const FieldGeometry& field) { return asResult(findFlaw(field)); }
Result<void> validate(const Layout& layout) { return asResult(findFlaw(layout)); }
Result<void> validate(const Layout& layout, const FieldGeometry& field) {
  return asResult(findFlaw(layout, field));
}

}  // namespace fulbito
