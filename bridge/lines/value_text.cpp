#include "bridge/lines/value_text.hpp"

#include <limits>

namespace fulbito::lines {
namespace {

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

/// An object of the members that `members` appends.
template <typename T>
void appendObject(std::string& out, void (*members)(std::string&, const T&), const T& value) {
  out += '{';
  members(out, value);
  out += '}';
}

}  // namespace

void append(std::string& out, MatchEnd::Reason reason) {
  constexpr const char* kReasons[] = {"played", "abandoned", "interrupted"};
  json::append(out, kReasons[static_cast<std::size_t>(reason)]);
}

void append(std::string& out, Exercise::Kind kind) {
  constexpr const char* kTasks[] = {"reach-pose", "turn", "reach-ball", "push", "predict-ball"};
  json::append(out, kTasks[static_cast<std::size_t>(kind)]);
}

void append(std::string& out, Seed value) {
  out += '"';
  json::append(out, value.seed);
  out += '"';
}

void append(std::string& out, Vec2 point) {
  add(out, R"({"x":)", point.x);
  add(out, R"(,"y":)", point.y);
  out += '}';
}

void append(std::string& out, const BallState& ball) { appendObject(out, appendBall, ball); }
void append(std::string& out, VisionOf vision) { appendObject(out, appendVision, vision.info); }
void append(std::string& out, const Observation& seen) { appendObject(out, appendObservation, seen); }
void append(std::string& out, const Exercise& exercise) { appendObject(out, appendExercise, exercise); }

void append(std::string& out, const DecisionTime& time) {
  if (std::isfinite(time.decision)) return appendObject(out, appendDecisionTime, time);
  json::append(out, nullptr);  // JSON has no infinity
}

void append(std::string& out, const GameEvent& call) {
  if (!call.clause.empty()) return appendObject(out, appendCall, call);
  json::append(out, nullptr);
}

void append(std::string& out, OwnRobots robots) {
  const Observation& seen = robots.seen;
  appendRobots(out, seen.team_size, [&](std::size_t i) {
    if (!seen.own[i].present) return false;
    out += '{';
    appendOwnRobot(out, seen.own[i].state, seen.sent[i]);
    return true;
  });
}

void append(std::string& out, OtherRobots robots) {
  const Observation& seen = robots.seen;
  appendRobots(out, seen.team_size, [&](std::size_t i) {
    if (!seen.opponents[i].present) return false;
    out += '{';
    appendRobot(out, seen.opponents[i].state);
    return true;
  });
}

void append(std::string& out, PosesOf list) {
  if (list.poses == nullptr) return json::append(out, nullptr);
  appendRobots(out, list.team_size, [&](std::size_t i) {
    const std::optional<Pose2>& pose = (*list.poses)[i];
    if (!pose) return false;
    add(out, R"({"x":)", pose->position.x);
    add(out, R"(,"y":)", pose->position.y);
    add(out, R"(,"heading":)", pose->heading);
    return true;
  });
}

void read(json::Reader& in, double& into) {
  if (in.takeNull()) {
    into = std::numeric_limits<double>::quiet_NaN();
  } else {
    in.number(into);
  }
}

void read(json::Reader& in, std::uint8_t& into) {
  std::int64_t value = 0;
  if (in.integer(value, 0, 255)) into = static_cast<std::uint8_t>(value);
}

void read(json::Reader& in, std::optional<double>& into) {
  if (!in.takeNull()) in.number(into.emplace());
}

}  // namespace fulbito::lines
