#include "bridge/lines/write_values.hpp"

#include <algorithm>
#include <span>

#include "fulbito/detail/lines/json_text.hpp"

namespace fulbito::lines {
namespace {

/// A member after others, `name` with its comma, quotes and colon.
template <typename T>
void add(std::string& out, std::string_view name, const T& value) {
  out += name;
  json::append(out, value);
}

void append(std::string& out, const Pose2& pose) {
  add(out, R"({"x":)", pose.position.x);
  add(out, R"(,"y":)", pose.position.y);
  add(out, R"(,"heading":)", pose.heading);
}

void append(std::string& out, const RobotState& robot) {
  append(out, robot.pose);
  add(out, R"(,"vx":)", robot.velocity.x);
  add(out, R"(,"vy":)", robot.velocity.y);
  add(out, R"(,"omega":)", robot.angular_velocity);
}

/// Own robots: the wheels too, as they turn and as they were commanded.
void append(std::string& out, const RobotState& robot, WheelSpeeds sent) {
  append(out, robot);
  add(out, R"(,"left":)", robot.wheels.left);
  add(out, R"(,"right":)", robot.wheels.right);
  add(out, R"(,"sent_left":)", sent.left);
  add(out, R"(,"sent_right":)", sent.right);
}

/// A list with one item per robot number; `item` appends an object without its closing brace, or nothing.
template <typename Item>
void appendRobots(std::string& out, int team_size, Item item) {
  out += '[';
  const auto count = static_cast<std::size_t>(std::clamp(team_size, 0, kMaxTeamSize));
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) out += ',';
    out += item(i) ? "}" : "null";
  }
  out += ']';
}

constexpr std::string_view kExercises[] = {"reach-pose", "turn", "reach-ball", "push", "predict-ball"};

}  // namespace

void append(std::string& out, Vec2 point) {
  add(out, R"({"x":)", point.x);
  add(out, R"(,"y":)", point.y);
  out += '}';
}

void append(std::string& out, const Observation& seen) {
  add(out, R"({"tick":)", seen.tick);
  add(out, R"(,"period":)", seen.period);
  add(out, R"(,"remaining":)", seen.remaining);
  add(out, R"(,"playing":)", seen.playing);
  add(out, R"(,"restart":)", nameOf(seen.restart));
  add(out, R"(,"restart_is_ours":)", seen.restart_is_ours);
  add(out, R"(,"since_restart":)", seen.since_restart);
  add(out, R"(,"own_score":)", seen.own_score);
  add(out, R"(,"opponent_score":)", seen.opponent_score);
  add(out, R"(,"wants_drawings":)", seen.wants_drawings);
  add(out, R"(,"ball":{"x":)", seen.ball.position.x);
  add(out, R"(,"y":)", seen.ball.position.y);
  add(out, R"(,"vx":)", seen.ball.velocity.x);
  add(out, R"(,"vy":)", seen.ball.velocity.y);
  out += R"(},"own":)";
  appendRobots(out, seen.team_size, [&](std::size_t i) {
    if (seen.own[i].present) append(out, seen.own[i].state, seen.sent[i]);
    return seen.own[i].present;
  });
  out += R"(,"opponents":)";
  appendRobots(out, seen.team_size, [&](std::size_t i) {
    if (seen.opponents[i].present) append(out, seen.opponents[i].state);
    return seen.opponents[i].present;
  });
  out += '}';
}

void append(std::string& out, const GameEvent& event) {
  if (event.clause.empty()) {
    out += "null";
    return;
  }
  add(out, R"({"clause":)", event.clause);
  add(out, R"(,"law":)", event.law);
  out += R"(,"team":)";
  event.team ? json::append(out, nameOf(*event.team)) : json::append(out, nullptr);
  out += R"(,"robot":)";
  event.robot ? json::append(out, *event.robot) : json::append(out, nullptr);
  add(out, R"(,"x":)", event.place.x);
  add(out, R"(,"y":)", event.place.y);
  add(out, R"(,"tick":)", event.tick);
  add(out, R"(,"period":)", event.period);
  add(out, R"(,"play_time":)", event.play_time);
  add(out, R"(,"value":)", event.value);
  add(out, R"(,"threshold":)", event.threshold);
  add(out, R"(,"margin":)", event.margin);
  out += '}';
}

void append(std::string& out, const TeamPlacement& poses, int team_size) {
  appendRobots(out, team_size, [&](std::size_t i) {
    if (poses[i]) append(out, *poses[i]);
    return poses[i].has_value();
  });
}

void append(std::string& out, const Exercise& exercise) {
  add(out, R"({"kind":)", kExercises[static_cast<std::size_t>(exercise.kind)]);
  add(out, R"(,"x":)", exercise.target.x);
  add(out, R"(,"y":)", exercise.target.y);
  add(out, R"(,"heading":)", exercise.heading);
  add(out, R"(,"speed":)", exercise.speed);
  add(out, R"(,"horizon":)", exercise.horizon);
  out += '}';
}

}  // namespace fulbito::lines
