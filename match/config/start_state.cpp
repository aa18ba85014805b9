#include <algorithm>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "engine/core/config/config_document.hpp"
#include "engine/core/system/text_file.hpp"
#include "fulbito/match.hpp"

namespace fulbito {
namespace {

constexpr double kFar = 20.0;       // [m]
constexpr double kMaxSpeed = 50.0;  // [m/s]
constexpr double kMaxPlay = 1e5;    // [s]

/// A robot as the file describes it.
struct StartRobot {
  TeamId team = TeamId::kBlue;
  int number = 0;
  Pose2 pose;
};

Schema ballSchema(Placement& placement) {
  return {{"position", &placement.ball, -kFar, kFar, "m", "", true},
          {"velocity", &placement.ball_velocity, -kMaxSpeed, kMaxSpeed, "m/s", "", false}};
}

Schema robotSchema(StartRobot& robot) {
  return {{"team", choice(robot.team, {"blue", "yellow"}), 0, 0, "", "", true},
          {"number", &robot.number, 0, kMaxTeamSize - 1, "", "in the team, from 0", true},
          {"position", &robot.pose.position, -kFar, kFar, "m", "", true},
          {"heading", Heading{&robot.pose.heading}, -36000.0, 36000.0, "rad", "counter-clockwise from +x",
           false}};
}

Choice restartChoice(RestartKind& restart) {
  std::vector<std::string> names;
  for (int i = 0; i <= static_cast<int>(RestartKind::kGiven); ++i) {
    names.emplace_back(nameOf(static_cast<RestartKind>(i)));
  }
  return choice(restart, std::move(names));
}

Schema matchSchema(StartState& start) {
  Scoreboard& board = start.scoreboard;
  return {{"blue", &board.score[0], 0, 1000, "", "goals so far", false},
          {"yellow", &board.score[1], 0, 1000, "", "goals so far", false},
          {"period", &board.period, 1, 3, "", "1, 2: halves; 3: overtime", false},
          {"play_seconds", &board.play_seconds, 0.0, kMaxPlay, "s", "elapsed play time in the period", false},
          {"restart", restartChoice(start.restart), 0, 0, "", "what the teams take the start for", false},
          {"team", choice(start.team, {"blue", "yellow"}), 0, 0, "", "that takes the restart", false}};
}

Result<void> readRobots(const ConfigDocument& document, Placement& placement) {
  const auto count = document.count("robot");
  if (!count) return tl::unexpected<Error>(count.error());
  for (int i = 0; i < *count; ++i) {
    StartRobot robot;
    if (auto read = document.readElement("robot", i, robotSchema(robot)); !read) return read;
    auto& place = placement.robots[indexOf(robot.team)][static_cast<std::size_t>(robot.number)];
    if (place) {
      return document.locate({"robot", i, "number",
                              fmt::format("= {} of {} is listed twice", robot.number, nameOf(robot.team))});
    }
    place = robot.pose;
  }
  return {};
}

Result<ConfigDocument> parse(std::string_view text, const std::string& origin) {
  static const std::vector<std::string> kTables{"ball", "robot", "match"};
  return ConfigDocument::parse(text, origin, kTables);
}

Result<StartState> read(const ConfigDocument& document) {
  StartState start;
  for (const auto& done :
       {document.read("ball", ballSchema(start.placement), true), readRobots(document, start.placement),
        document.read("match", matchSchema(start), false)}) {
    if (!done) return tl::unexpected<Error>(done.error());
  }
  return start;
}

/// A body of a start state as the largest disc inside it, whatever its heading.
struct StartBody {
  std::string name;
  Vec2 position;
  double radius = 0.0;  ///< [m]
};

/// The flaw of a body, given those before it; empty: none.
std::string flawOf(const StartBody& body, const std::vector<StartBody>& others, const FieldGeometry& field) {
  const std::string place = fmt::format("= [{}, {}]", body.position.x, body.position.y);
  if (!insideField(field, body.position)) {
    return fmt::format("{} is outside the field '{}'", place, field.name);
  }
  for (const StartBody& other : others) {
    if (distance(body.position, other.position) >= body.radius + other.radius) continue;
    return fmt::format("{} overlaps {} at [{}, {}]", place, other.name, other.position.x, other.position.y);
  }
  return {};
}

/// The first flaw of a start state for this match.
std::optional<Flaw> findFlaw(const ConfigDocument& document, const StartState& start,
                             const MatchConfig& match) {
  const RobotModel& robot = match.robot.robot;
  std::vector<StartBody> bodies{{"the ball", start.placement.ball, match.robot.ball.radius}};
  if (std::string flaw = flawOf(bodies.front(), {}, match.field); !flaw.empty()) {
    return Flaw{"ball", -1, "position", std::move(flaw)};
  }
  const int count = document.count("robot").value_or(0);
  for (int i = 0; i < count; ++i) {
    StartRobot listed;
    if (!document.readElement("robot", i, robotSchema(listed))) continue;  // cannot fail: it was read before
    if (listed.number >= match.rules.team_size) {
      return Flaw{"robot", i, "number",
                  fmt::format("= {}: the rules '{}' have {} robots per team, counted from 0", listed.number,
                              match.rules.name, match.rules.team_size)};
    }
    StartBody body{fmt::format("robot {} of {}", listed.number, nameOf(listed.team)), listed.pose.position,
                   std::min(robot.length, robot.width) / 2};
    if (std::string flaw = flawOf(body, bodies, match.field); !flaw.empty()) {
      return Flaw{"robot", i, "position", std::move(flaw)};
    }
    bodies.push_back(std::move(body));
  }
  if (!(start.scoreboard.play_seconds <= match.rules.half_seconds)) {
    return Flaw{"match", -1, "play_seconds",
                fmt::format("= {} is longer than a half, {} s", start.scoreboard.play_seconds,
                            match.rules.half_seconds)};
  }
  return std::nullopt;
}

}  // namespace

Result<StartState> parseStartState(std::string_view text, const std::string& origin) {
  const auto document = parse(text, origin);
  if (!document) return tl::unexpected<Error>(document.error());
  return read(*document);
}

Result<StartState> loadStartState(const std::string& file) {
  const auto text = readTextFile(file, kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseStartState(*text, file);
}

Result<StartState> loadStartState(const std::string& file, const MatchConfig& match) {
  const auto text = readTextFile(file, kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  const auto document = parse(*text, file);
  if (!document) return tl::unexpected<Error>(document.error());
  auto start = read(*document);
  if (!start) return start;
  if (const auto flaw = findFlaw(*document, *start, match)) return document->locate(*flaw);
  return start;
}

std::string toToml(const StartState& start) {
  StartState copy = start;
  std::string text = fmt::format("[match]\n{}\n[ball]\n{}", tableText(matchSchema(copy), false),
                                 tableText(ballSchema(copy.placement), false));
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
      const auto& pose = start.placement.robots[indexOf(team)][i];
      if (!pose) continue;
      StartRobot robot{team, static_cast<int>(i), *pose};
      text += fmt::format("\n[[robot]]\n{}", tableText(robotSchema(robot), false));
    }
  }
  return text;
}

void setStart(MatchConfig& match, const StartState& start) {
  match.start = start.placement;
  match.scoreboard = start.scoreboard;
  match.opening.reset();
  if (start.restart == RestartKind::kGiven) return;
  match.opening.emplace();
  match.opening->kind = start.restart;
  match.opening->team = start.team;
}

}  // namespace fulbito
