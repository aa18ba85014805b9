#include "match/start_state.hpp"

#include <fmt/format.h>

#include "engine/core/config_document.hpp"
#include "engine/core/text_file.hpp"

namespace fulbito {
namespace {

constexpr double kFar = 20.0;       // [m]
constexpr double kMaxSpeed = 50.0;  // [m/s]
constexpr double kMaxPlay = 1e5;    // [s]

/// A robot as it stands in a file.
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

Schema boardSchema(Scoreboard& board) {
  return {{"blue", &board.score[0], 0, 1000, "", "goals so far", false},
          {"yellow", &board.score[1], 0, 1000, "", "goals so far", false},
          {"period", &board.period, 1, 3, "", "1, 2: halves; 3: overtime", false},
          {"play_seconds", &board.play_seconds, 0.0, kMaxPlay, "s", "of play gone in the period", false}};
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
                              fmt::format("= {} of {} is there already", robot.number, nameOf(robot.team))});
    }
    place = robot.pose;
  }
  return {};
}

}  // namespace

Result<StartState> parseStartState(std::string_view text, const std::string& origin) {
  static const std::vector<std::string> kTables{"ball", "robot", "match"};
  auto document = ConfigDocument::parse(text, origin, kTables);
  if (!document) return tl::unexpected<Error>(document.error());
  StartState start;
  for (const auto& read :
       {document->read("ball", ballSchema(start.placement), true), readRobots(*document, start.placement),
        document->read("match", boardSchema(start.scoreboard), false)}) {
    if (!read) return tl::unexpected<Error>(read.error());
  }
  return start;
}

Result<StartState> loadStartState(const std::string& file) {
  const auto text = readTextFile(file, kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseStartState(*text, file);
}

std::string toToml(const StartState& start) {
  StartState copy = start;
  std::string text = fmt::format("[match]\n{}\n[ball]\n{}", tableText(boardSchema(copy.scoreboard), false),
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

}  // namespace fulbito
