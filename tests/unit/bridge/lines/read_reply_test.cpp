#include <cmath>
#include <fstream>
#include <set>

#include "bridge/lines/line_codec.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

struct Case {
  std::string outcome, reply;
};

std::vector<Case> cases() {
  std::vector<Case> found;
  std::ifstream in(FULBITO_SOURCE_DIR "/tests/unit/bridge/lines/replies.txt");
  for (std::string line; std::getline(in, line);) {
    const std::size_t tab = line.find('\t');
    if (line.starts_with('#') || tab == std::string::npos) continue;
    std::string outcome = line.substr(0, tab);
    if (outcome.starts_with('[')) outcome = outcome.substr(1, outcome.size() - 2);
    found.push_back({outcome, line.substr(tab + 1)});
  }
  return found;
}

TeamReply readGood(const std::string& line) {
  LineCodec codec;
  TeamReply reply;
  const auto read = codec.read(line, reply);
  INFO(line);
  INFO((read ? std::string() : read.error().message));
  REQUIRE(read);
  return reply;
}

}  // namespace

TEST_CASE("replies of teams are read, or refused with the member that is wrong", "[unit]") {
  LineCodec codec;
  TeamReply reply;
  std::set<std::string> outcomes;
  for (const Case& c : cases()) {
    CAPTURE(c.reply);
    const auto read = codec.read(c.reply + '\n', reply);
    CHECK((read ? "ok" : read.error().message) == c.outcome);
    if (!read) CHECK(read.error().code == ErrorCode::kBadInput);
    outcomes.insert(c.outcome);
  }
  CHECK(outcomes.size() > 50);
}

TEST_CASE("a reply's values arrive, whatever the order of its members", "[unit]") {
  const TeamReply reply = readGood(
      R"({"drawings":[{"text":[0.5,-0.5,"k\u00fcr\n"]},{"circle":[1,2,3]},{"line":[1,2,3,4]}],"roles":[3,1],)"
      R"("robots":[{"right":-2.5,"left":1e1},{"angular":0.1,"linear":null},)"
      R"({"go_to":{"y":2,"x":1,"speed_limit":0.5,"navigator":7,"avoid_mates":false}}],"id":77,"type":"decide"})");
  CHECK(reply.kind == TeamReply::Kind::kDecide);
  CHECK(reply.id == 77);
  const auto& robots = reply.command.robots;
  CHECK(robots[0].kind == RobotCommand::Kind::kWheels);
  CHECK(robots[0].wheels.left == 10.0);
  CHECK(robots[0].wheels.right == -2.5);
  CHECK(robots[1].kind == RobotCommand::Kind::kTwist);
  CHECK(std::isnan(robots[1].twist.linear));
  CHECK(robots[1].twist.angular == 0.1);
  CHECK(robots[2].kind == RobotCommand::Kind::kGoTo);
  CHECK(robots[2].go_to.position == Vec2{1.0, 2.0});
  CHECK(robots[2].go_to.speed_limit == 0.5);
  CHECK(robots[2].go_to.navigator == 7);
  CHECK_FALSE(robots[2].go_to.avoid_mates);
  CHECK(robots[2].go_to.avoid_opponents);
  CHECK_FALSE(robots[2].go_to.heading);
  CHECK(robots[3].kind == RobotCommand::Kind::kWheels);
  CHECK(robots[3].wheels.left == 0.0);
  CHECK(reply.command.roles[0] == 3);
  CHECK(reply.command.roles[2] == 0);
  REQUIRE(reply.command.drawings.size() == 3);
  CHECK(reply.command.drawings[0].text == "k\xC3\xBCr\n");
  CHECK(reply.command.drawings[1].radius == 3.0);
  CHECK(reply.command.drawings[2].to == Vec2{3.0, 4.0});
}

TEST_CASE("a reply keeps nothing of the one before it", "[unit]") {
  LineCodec codec;
  TeamReply reply;
  REQUIRE(
      codec.read(R"({"type":"hello","id":1,"protocol":"fulbito-team/1","name":"x","version":"2"})", reply));
  REQUIRE(codec.read(R"({"type":"begin","id":2,"navigators":["a","b"]})", reply));
  REQUIRE(codec.read(R"({"type":"place","id":3,"poses":[{"x":1,"y":1,"heading":0}],"ball":{"x":0,"y":0}})",
                     reply));
  REQUIRE(codec.read(
      R"({"type":"decide","id":4,"robots":[{"left":1,"right":1}],"roles":[1],"drawings":[{"line":[0,0,1,1]}]})",
      reply));
  REQUIRE(codec.read(R"({"type":"exercise","id":5,"robots":[null],"answer":{"x":1,"y":1}})", reply));
  REQUIRE(codec.read(R"({"type":"hello","id":6,"protocol":"fulbito-team/1","name":"y"})", reply));
  CHECK(reply.welcome.version.empty());
  REQUIRE(codec.read(R"({"type":"begin","id":7})", reply));
  CHECK(reply.navigators.empty());
  REQUIRE(codec.read(R"({"type":"place","id":8,"poses":[null]})", reply));
  REQUIRE(reply.proposal);
  CHECK_FALSE(reply.proposal->robots[0]);
  CHECK_FALSE(reply.proposal->ball);
  REQUIRE(codec.read(R"({"type":"place","id":8})", reply));
  CHECK_FALSE(reply.proposal);
  REQUIRE(codec.read(R"({"type":"decide","id":9,"robots":[]})", reply));
  CHECK(reply.command.robots[0].wheels.left == 0.0);
  CHECK(reply.command.roles[0] == 0);
  CHECK(reply.command.drawings.empty());
  REQUIRE(codec.read(R"({"type":"exercise","id":10})", reply));
  CHECK_FALSE(reply.exercise);
}

TEST_CASE("a line ends at its line end, and no line is longer than 1 MiB", "[unit]") {
  const LineCodec codec;
  CHECK(*codec.firstMessage("") == 0);
  CHECK(*codec.firstMessage("{\"type\"") == 0);
  CHECK(*codec.firstMessage("{}\n{}\n") == 3);
  CHECK(*codec.firstMessage("\r\n") == 2);
  std::string line(LineCodec::kMaxLine - 1, ' ');
  CHECK(*codec.firstMessage(line) == 0);
  CHECK(*codec.firstMessage(line + '\n') == LineCodec::kMaxLine);
  line += ' ';
  REQUIRE_FALSE(codec.firstMessage(line));
  CHECK(codec.firstMessage(line).error().message == "a line is longer than 1 MiB");
  CHECK_FALSE(codec.firstMessage(line + '\n'));
}

}  // namespace fulbito
