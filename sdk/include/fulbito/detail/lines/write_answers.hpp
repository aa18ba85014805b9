// Writes the answers of a team's program as JSON.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "fulbito/detail/lines/json_text.hpp"
#include "fulbito/team.hpp"

namespace fulbito::team::program {

/// Appends one member; `name` brings the comma or brace before it.
template <typename T>
void add(std::string& out, std::string_view name, const T& value) {
  out += name;
  json::append(out, value);
}

/// Appends a place to drive to.
inline void append(std::string& out, const GoTo& go_to) {
  // As null, these would mean "any heading" and "no limit". So a NaN here makes the position null, which is a
  // fault.
  const bool broken = std::isnan(go_to.speed_limit) || (go_to.heading && !std::isfinite(*go_to.heading));
  add(out, R"({"go_to":{"x":)", broken ? std::numeric_limits<double>::quiet_NaN() : go_to.position.x);
  add(out, R"(,"y":)", go_to.position.y);
  if (go_to.heading) add(out, R"(,"heading":)", *go_to.heading);
  if (std::isfinite(go_to.speed_limit)) add(out, R"(,"speed_limit":)", go_to.speed_limit);
  add(out, R"(,"tolerance":)", go_to.tolerance);
  const GoTo usual;
  if (go_to.stop != usual.stop) add(out, R"(,"stop":)", go_to.stop);
  if (go_to.avoid_ball != usual.avoid_ball) add(out, R"(,"avoid_ball":)", go_to.avoid_ball);
  if (go_to.avoid_mates != usual.avoid_mates) add(out, R"(,"avoid_mates":)", go_to.avoid_mates);
  if (go_to.avoid_opponents != usual.avoid_opponents)
    add(out, R"(,"avoid_opponents":)", go_to.avoid_opponents);
  if (go_to.either_front != usual.either_front) add(out, R"(,"either_front":)", go_to.either_front);
  if (go_to.navigator != usual.navigator) add(out, R"(,"navigator":)", go_to.navigator);
  out += "}}";
}

/// Appends a robot's command.
inline void append(std::string& out, const Command& command) {
  if (command.kind == Command::Kind::kGoTo) return append(out, command.go_to);
  const bool twist = command.kind == Command::Kind::kTwist;
  add(out, twist ? R"({"linear":)" : R"({"left":)", twist ? command.twist.linear : command.wheels.left);
  add(out, twist ? R"(,"angular":)" : R"(,"right":)", twist ? command.twist.angular : command.wheels.right);
  out += '}';
}

/// Whether all numbers of a drawing are finite; others are left out.
inline bool drawable(const Drawing& d) {
  return std::isfinite(d.from.x) && std::isfinite(d.from.y) && std::isfinite(d.to.x) &&
         std::isfinite(d.to.y) && std::isfinite(d.radius);
}

/// Appends a drawing.
inline void append(std::string& out, const Drawing& d) {
  constexpr std::string_view kShapes[] = {R"({"line":[)", R"({"circle":[)", R"({"text":[)"};
  add(out, kShapes[static_cast<std::size_t>(d.kind)], d.from.x);
  add(out, ",", d.from.y);
  if (d.kind == Drawing::Kind::kLine) {
    add(out, ",", d.to.x);
    add(out, ",", d.to.y);
  } else if (d.kind == Drawing::Kind::kCircle) {
    add(out, ",", d.radius);
  } else {
    add(out, ",", std::string_view(d.text));
  }
  out += "]}";
}

/// Appends the numbers of the roles, if the team reports any.
inline void appendRoles(std::string& out, const Commands& commands, std::size_t team_size) {
  const auto& roles = commands.roles;
  if (std::all_of(roles.begin(), roles.end(), [](std::uint8_t role) { return role == 0; })) return;
  for (std::size_t i = 0; i < team_size; ++i) add(out, i == 0 ? R"(,"roles":[)" : ",", roles[i]);
  out += ']';
}

/// Appends commands of all robots, roles and drawings, with a comma before each.
inline void append(std::string& out, const Commands& commands, std::size_t team_size) {
  out += R"(,"robots":[)";
  for (std::size_t i = 0; i < team_size; ++i) {
    if (i > 0) out += ',';
    append(out, commands.robots[i]);
  }
  out += ']';
  appendRoles(out, commands, team_size);
  if (commands.drawings.empty()) return;
  out += R"(,"drawings":[)";
  bool first = true;
  for (const Drawing& drawing : commands.drawings) {
    if (!drawable(drawing)) continue;
    if (!first) out += ',';
    first = false;
    append(out, drawing);
  }
  out += ']';
}

/// Appends poses of all robots.
inline void append(std::string& out, const Poses& poses, std::size_t team_size) {
  out += R"(,"poses":[)";
  for (std::size_t i = 0; i < team_size; ++i) {
    if (i > 0) out += ',';
    if (!poses[i]) {
      out += "null";
      continue;
    }
    add(out, R"({"x":)", poses[i]->position.x);
    add(out, R"(,"y":)", poses[i]->position.y);
    add(out, R"(,"heading":)", poses[i]->heading);
    out += '}';
  }
  out += ']';
}

/// Appends a point as a member.
inline void append(std::string& out, std::string_view name, Vec2 point) {
  out += name;
  add(out, R"({"x":)", point.x);
  add(out, R"(,"y":)", point.y);
  out += '}';
}

}  // namespace fulbito::team::program
