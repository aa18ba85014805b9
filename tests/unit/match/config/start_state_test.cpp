#include <string>

#include <fmt/format.h>

#include "fulbito/match.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

constexpr const char* kText = R"(
[match]
blue = 2
period = 2
play_seconds = 12.5
[ball]
position = [0.1, -0.2]
velocity = [1.0, 0.0]
[[robot]]
team = "yellow"
number = 1
position = [0.3, 0.25]
heading_deg = 90
[[robot]]
team = "blue"
number = 0
position = [-0.3, 0.0]
)";

std::string refusal(const std::string& text) {
  const auto start = parseStartState(text, "s.toml");
  return start ? "accepted" : start.error().message;
}

}  // namespace

TEST_CASE("a start state is read as written, and written as read", "[unit]") {
  const auto start = parseStartState(kText, "s.toml");
  REQUIRE(start);
  CHECK(start->scoreboard.score[0] == 2);
  CHECK(start->scoreboard.score[1] == 0);
  CHECK(start->scoreboard.period == 2);
  CHECK(start->scoreboard.play_seconds == 12.5);
  CHECK(start->placement.ball == Vec2{0.1, -0.2});
  CHECK(start->placement.ball_velocity == Vec2{1.0, 0.0});
  REQUIRE(start->placement.robots[1][1]);
  CHECK(start->placement.robots[1][1]->heading == Approx(1.5707963267948966));
  REQUIRE(start->placement.robots[0][0]);
  CHECK_FALSE(start->placement.robots[0][1]);

  const std::string text = toToml(*start);
  const auto again = parseStartState(text, "again");
  REQUIRE(again);
  CHECK(toToml(*again) == text);
  CHECK(again->placement.robots[1][1]->heading == start->placement.robots[1][1]->heading);
  CHECK(again->placement.ball == start->placement.ball);
  CHECK(again->scoreboard.play_seconds == 12.5);
}

TEST_CASE("a start state says which restart it is, and for whom", "[unit]") {
  const std::string ball = "[ball]\nposition = [0.375, 0.4]\n";
  const auto plain = parseStartState(ball, "s.toml");
  REQUIRE(plain);
  CHECK(plain->restart == RestartKind::kGiven);
  const auto start =
      parseStartState(ball + "[match]\nrestart = \"free-ball\"\nteam = \"yellow\"\n", "s.toml");
  REQUIRE(start);
  CHECK(start->restart == RestartKind::kFreeBall);
  CHECK(start->team == TeamId::kYellow);
  CHECK(toToml(*parseStartState(toToml(*start), "again")) == toToml(*start));
  CHECK(refusal(ball + "[match]\nrestart = \"throw-in\"\n").starts_with("s.toml:4: match.restart"));
  CHECK(refusal(ball + "[match]\nteam = \"red\"\n").starts_with("s.toml:4: match.team"));

  MatchConfig match = test::shortMatch("chaser", "chaser", 5.0);
  setStart(match, *start);
  REQUIRE(match.opening);
  CHECK(match.opening->kind == RestartKind::kFreeBall);
  CHECK(match.opening->team == TeamId::kYellow);
  REQUIRE(match.start);
  CHECK(match.start->ball == Vec2{0.375, 0.4});
  setStart(match, *plain);
  CHECK_FALSE(match.opening);
}

TEST_CASE("a start state comes from a file", "[unit]") {
  const test::ScratchFolder folder;
  const auto start = loadStartState(folder.write("s.toml", kText));
  REQUIRE(start);
  CHECK(start->placement.ball.x == 0.1);
  const auto missing = loadStartState((folder.path() / "none.toml").string());
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == ErrorCode::kIo);
}

TEST_CASE("a bad start state is refused with file, line and key", "[unit]") {
  CHECK(refusal("[ball]\nposition = [0, 0]\n") == "accepted");
  CHECK(refusal("") == "s.toml:1: the table [ball] is missing");
  CHECK(refusal("[ball]\nposition = [0, 0]\nspeed = 1\n").rfind("s.toml:3: ball.speed", 0) == 0);
  CHECK(refusal("[ball]\nposition = [0, 0]\n[[robot]]\nteam = \"green\"\nnumber = 0\nposition = [0, 0]\n")
            .rfind("s.toml:4: robot[0].team", 0) == 0);
  CHECK(refusal("[ball]\nposition = [0, 0]\n[[robot]]\nteam = \"blue\"\nnumber = 11\nposition = [0, 0]\n")
            .rfind("s.toml:5: robot[0].number", 0) == 0);
  const std::string robot = "[[robot]]\nteam = \"blue\"\nnumber = 1\nposition = [0, 0]\n";
  CHECK(refusal("[ball]\nposition = [0, 0]\n" + robot + robot) ==
        "s.toml:9: robot[1].number = 1 of blue is listed twice");
  CHECK(refusal("[ball]\nposition = [0, nan]\n").rfind("s.toml:2: ball.position", 0) == 0);
  CHECK(refusal("[ball]\nposition = [0, 0]\n[match]\nperiod = 4\n").rfind("s.toml:4: match.period", 0) == 0);
}

TEST_CASE("a start that its match cannot take is named with file, line and key", "[unit]") {
  const test::ScratchFolder folder;
  MatchConfig match = test::shortMatch("chaser", "chaser", 5.0);
  const auto flaw = [&](const std::string& text) {
    const auto start = loadStartState(folder.write("s.toml", text), match);
    if (start) return std::string("none");
    CHECK(start.error().code == ErrorCode::kBadInput);
    const std::string& message = start.error().message;
    return message.substr(message.find("s.toml:"));
  };
  const std::string ball = "[ball]\nposition = [0.1, 0.1]\n";
  const auto robot = [](int number, const char* place) {
    return fmt::format("[[robot]]\nteam = \"blue\"\nnumber = {}\nposition = {}\n", number, place);
  };
  CHECK(flaw(ball + robot(0, "[0.3, 0.1]")) == "none");
  CHECK(flaw("[ball]\nposition = [5, 5]\n").starts_with("s.toml:2: ball.position = [5, 5] is outside"));
  CHECK(flaw(ball + robot(0, "[0.3, 0.1]") + robot(1, "[0.31, 0.1]")).starts_with("s.toml:10: "));
  CHECK(flaw(ball + robot(0, "[0.1, 0.1]")).find("overlaps the ball") != std::string::npos);
  CHECK(flaw(ball + robot(0, "[5, 5]")).find("is outside the field") != std::string::npos);
  CHECK(flaw(ball + robot(9, "[0.3, 0.1]")).find("counted from 0") != std::string::npos);
  CHECK(flaw(ball + "[match]\nplay_seconds = 240\n").starts_with("s.toml:4: match.play_seconds = 240"));
}

}  // namespace fulbito
