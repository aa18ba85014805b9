#include "tests/unit/bridge/lines/session.hpp"

#include <fstream>
#include <limits>

#include <nlohmann/json.hpp>

#include "bridge/lines/line_codec.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/piped_team.hpp"
#include "tests/unit/bridge/lines/port_commands.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr const char* kFile = FULBITO_SOURCE_DIR "/docs/team-protocol-session.txt";

/// A request or notice, and its answer if it has one; without marks and line ends.
struct Exchange {
  std::string said, answered;
};

/// Lines of the simulator begin with "> ", those of the team with "< ".
std::vector<Exchange> recorded() {
  std::vector<Exchange> session;
  std::ifstream in(kFile);
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("> ")) session.push_back({line.substr(2), {}});
    if (line.starts_with("< ") && !session.empty()) session.back().answered = line.substr(2);
  }
  return session;
}

}  // namespace

TEST_CASE("a match without a limit of time has none in the protocol, which has no infinity", "[unit]") {
  const auto limitFor = [](double seconds) {
    MatchInfo info;
    info.decision_time = DecisionTime{};
    info.decision_time->decision = seconds;
    std::string line;
    LineCodec().begin(1, info, line);
    return nlohmann::json::parse(line)["decision_time"];
  };
  CHECK(limitFor(std::numeric_limits<double>::infinity()).is_null());
  CHECK(limitFor(0.25)["decision"] == 0.25);
}

TEST_CASE("the simulator says what the sample session says, byte for byte", "[unit]") {
  INFO("write it anew: build/release/tests/unit/bridge/lines/print_session > docs/team-protocol-session.txt");
  const auto session = recorded();
  const auto lines = sessionLines();
  REQUIRE(session.size() == lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) CHECK(session[i].said + '\n' == lines[i]);
}

TEST_CASE("the simulator understands the answers of the sample session", "[unit]") {
  LineCodec codec;
  TeamReply reply;
  std::uint64_t id = 0;
  std::vector<TeamReply> replies;
  for (const Exchange& exchange : recorded()) {
    CAPTURE(exchange.answered);
    const bool request = nlohmann::json::parse(exchange.said).contains("id");
    REQUIRE(request == !exchange.answered.empty());
    if (!request) continue;
    const auto read = codec.read(exchange.answered + '\n', reply);
    INFO((read ? "" : read.error().message));
    REQUIRE(read);
    CHECK(reply.id == ++id);
    replies.push_back(reply);
  }
  REQUIRE(replies.size() == 11);
  CHECK(replies[0].welcome.name == "trio");
  CHECK(replies[1].navigators == std::vector<std::string>{"bezier:clearance=0.03"});
  REQUIRE(replies[2].proposal);
  CHECK(replies[2].proposal->robots[1]->position == Vec2{-0.1, 0.0});
  CHECK_FALSE(replies[2].proposal->robots[0]);
  const TeamCommand& command = replies[5].command;
  CHECK(command.robots[0].kind == RobotCommand::Kind::kGoTo);
  CHECK(command.robots[0].go_to.position == Vec2{-0.625, 0.1});
  CHECK(command.robots[0].go_to.stop);
  CHECK(command.robots[0].go_to.tolerance == 0.01);
  CHECK(command.robots[1].go_to.avoid_ball);
  CHECK(command.robots[2].go_to.speed_limit == 0.8);
  CHECK(command.roles == std::array<std::uint8_t, kMaxTeamSize>{1, 2, 3});
  REQUIRE(command.drawings.size() == 3);
  CHECK(command.drawings[2].text == "striker");
  CHECK_FALSE(replies[6].proposal);
  CHECK(replies[7].proposal->ball == Vec2{-0.6, 0.9 * 0.35});
  CHECK(replies[8].exercise->command.robots[0].go_to.heading == 1.5);
  CHECK(replies[9].exercise->answer == Vec2{0.2 + 0.5 * 0.625, 0.1});
  CHECK_FALSE(replies[10].exercise);
}

TEST_CASE("the team of the sample session answers as it did, byte for byte", "[unit]") {
  PipedProgram trio(pythonTeam("trio.py"));
  for (const Exchange& exchange : recorded()) {
    if (exchange.answered.empty()) {
      trio.send(exchange.said + '\n');
    } else {
      CHECK(answerOf(trio, exchange.said + '\n') == exchange.answered);
    }
  }
  CHECK(trio.finish() == 0);
}

}  // namespace fulbito
