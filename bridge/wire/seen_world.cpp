#include "bridge/wire/seen_world.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "fulbito/strategy.hpp"

namespace fulbito::wire {
namespace {

constexpr double kFieldAlike = 0.01;  // [m]

bool finite(const RobotState& robot) {
  return isFinite(robot.pose.position) && std::isfinite(robot.pose.heading) && isFinite(robot.velocity) &&
         std::isfinite(robot.angular_velocity);
}

}  // namespace

std::optional<SeenWorld> seenWorld(const Vision& vision, int team_size) {
  SeenWorld seen;
  seen.ball = vision.ball;
  if (!isFinite(vision.ball.position) || !isFinite(vision.ball.velocity)) return std::nullopt;
  for (const TeamId team : kTeams) {
    std::array<const SeenRobot*, kMaxTeamSize> known{};
    for (const SeenRobot& robot : vision.robots[indexOf(team)]) {
      if (robot.number >= static_cast<std::uint32_t>(team_size)) {
        ++seen.unknown;
      } else if (known[robot.number] == nullptr) {
        if (!finite(robot.state)) return std::nullopt;
        known[robot.number] = &robot;
      }
    }
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (known[i] == nullptr) continue;
      seen.ids.push_back({team, static_cast<std::uint8_t>(i)});
      seen.robots.push_back(known[i]->state);
    }
  }
  return seen;
}

Result<void> checkField(const Vision& vision, const FieldGeometry& field, const std::string& rules) {
  if (std::abs(vision.field.length - field.length) <= kFieldAlike &&
      std::abs(vision.field.width - field.width) <= kFieldAlike) {
    return {};
  }
  return fail(
      ErrorCode::kUsage,
      fmt::format("the server's field is {:.2f} x {:.2f} m, that of the rules {} is {:.2f} x {:.2f} m; "
                  "choose others with --rules",
                  vision.field.length, vision.field.width, rules, field.length, field.width));
}

}  // namespace fulbito::wire
