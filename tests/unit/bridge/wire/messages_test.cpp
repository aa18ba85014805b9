#include "bridge/wire/messages.hpp"

#include <bit>
#include <limits>
#include <numbers>
#include <random>

#include "tests/support/catch.hpp"

// Datagrams byte by byte, from the tables of the protocol: a field's key is its number times 8, plus 0 for a
// whole number, 1 for a double and 2 for what has a length.
namespace fulbito::wire {
namespace {

std::string byte(unsigned value) { return {static_cast<char>(value)}; }

std::string whole(unsigned field, unsigned value) { return byte(field * 8) + byte(value); }

std::string real(unsigned field, double value) {
  std::string bytes = byte(field * 8 + 1);
  const auto bits = std::bit_cast<std::uint64_t>(value);
  for (int i = 0; i < 8; ++i) bytes += static_cast<char>(bits >> (8 * i) & 0xff);
  return bytes;
}

std::string part(unsigned field, const std::string& content) {
  std::string length;
  for (std::size_t left = content.size();; left >>= 7) {
    length += static_cast<char>(left < 0x80 ? left : (left & 0x7f) | 0x80);
    if (left < 0x80) break;
  }
  return byte(field * 8 + 2) + length + content;
}

Vision someVision() {
  Vision vision;
  vision.step = 16;
  vision.ball = {{0.25, -0.5}, {1.5, -2.5}, {}};
  vision.ball_height = 0.0215;
  const RobotState blue{{{-0.75, 0.125}, -std::numbers::pi}, {0.5, -0.25}, 3.5, {}};
  const RobotState yellow{{{0.375, 0.625}, 0.5}, {-1.5, 0.75}, -6.5, {}};
  vision.robots[0].push_back({2, blue});
  vision.robots[1].push_back({1, yellow});
  vision.goals = {3, 4};
  return vision;
}

std::string robotBytes(unsigned id, const RobotState& robot, double orientation) {
  return whole(1, id) + real(2, robot.pose.position.x) + real(3, robot.pose.position.y) +
         real(4, orientation) + real(5, robot.velocity.x) + real(6, robot.velocity.y) +
         real(7, robot.angular_velocity);
}

}  // namespace

TEST_CASE("a frame of vision has the bytes of the league's simulator", "[unit]") {
  const Vision vision = someVision();
  const std::string ball = real(1, 0.25) + real(2, -0.5) + real(3, 0.0215) + real(4, 1.5) + real(5, -2.5);
  const std::string frame = part(1, ball) + part(2, robotBytes(1, vision.robots[1][0].state, 0.5)) +
                            part(3, robotBytes(2, vision.robots[0][0].state, std::numbers::pi));
  const std::string field = real(1, 1.3) + real(2, 1.5) + real(3, 0.4) + real(4, 0.1) + real(5, 0.2) +
                            real(6, 0.7) + real(7, 0.15) + real(8, 0.375);
  const std::string expected = whole(1, 16) + part(2, frame) + part(3, field) + whole(4, 3) + whole(5, 4);
  CHECK(datagramOf(vision) == expected);
  const auto read = readVision(expected);
  REQUIRE(read);
  CHECK(read->ball.velocity == Vec2{1.5, -2.5});
  CHECK(read->robots[1][0].number == 1);
  CHECK(read->robots[0][0].state.pose.heading == -std::numbers::pi);
  CHECK(read->field.length == 1.5);
  CHECK(read->goals == PerTeam<std::uint32_t>{3, 4});
}

TEST_CASE("a frame of vision with up to five a side is a datagram that every client reads whole", "[unit]") {
  Vision vision = someVision();
  for (const std::size_t size : {3U, 5U}) {
    for (auto& team : vision.robots) {
      team.assign(size, team.front());
      for (std::size_t i = 0; i < size; ++i) team[i].number = static_cast<std::uint32_t>(i);
    }
    CHECK(datagramOf(vision).size() <= kLongestVision);
    CHECK(datagramOf(vision).size() > 400);
  }
}

TEST_CASE("a packet has the bytes of the league's clients, and replacements are in degrees", "[unit]") {
  Packet packet;
  packet.commands = {{1, TeamId::kYellow, {-12.5, 40.0}}, {0, TeamId::kBlue, {1.0, 2.0}}};
  packet.ball = BallReplacement{{0.1, 0.2}, {0.3, 0.4}};
  packet.robots = {{2, TeamId::kYellow, {{0.5, -0.5}, std::numbers::pi / 2}, true}};
  const std::string commands = part(1, whole(1, 1) + whole(2, 1) + real(6, -12.5) + real(7, 40.0)) +
                               part(1, real(6, 1.0) + real(7, 2.0));
  const std::string place = whole(1, 2) + real(2, 0.5) + real(3, -0.5) + real(4, 90.0);
  const std::string replacement = part(1, real(1, 0.1) + real(2, 0.2) + real(3, 0.3) + real(4, 0.4)) +
                                  part(2, part(1, place) + whole(5, 1) + whole(6, 1));
  const std::string expected = part(1, commands) + part(2, replacement);
  CHECK(datagramOf(packet) == expected);
  const auto read = readPacket(expected);
  REQUIRE(read);
  CHECK(read->commands[0].team == TeamId::kYellow);
  CHECK(read->commands[0].wheels.left == -12.5);
  CHECK(read->commands[1].number == 0);
  CHECK(read->ball->velocity == Vec2{0.3, 0.4});
  CHECK(read->robots[0].pose.heading == Approx(std::numbers::pi / 2));
  CHECK(read->robots[0].on);
}

TEST_CASE("the parts of a packet may be missing: a ball is there if its part is, however empty", "[unit]") {
  CHECK(readPacket("")->commands.empty());
  CHECK(!readPacket("")->ball);
  const auto ball = readPacket(part(2, part(1, "")));
  REQUIRE(ball);
  REQUIRE(ball->ball);
  CHECK(ball->ball->position == Vec2{});
  const auto robot = readPacket(part(2, part(2, "")));
  REQUIRE(robot);
  CHECK_FALSE(robot->robots.at(0).on);  // without `turnon` a robot leaves
}

TEST_CASE("a referee's command has the bytes of the league's, and is never empty", "[unit]") {
  const RefereeCommand command{Foul::kFreeBall, std::nullopt, 3, 12.5, Half::kSecond};
  const std::string expected = whole(1, 3) + whole(2, 2) + whole(3, 3) + real(4, 12.5) + whole(5, 2);
  CHECK(datagramOf(command) == expected);
  const auto read = readRefereeCommand(expected);
  REQUIRE(read);
  CHECK(read->foul == Foul::kFreeBall);
  CHECK_FALSE(read->team);
  CHECK(read->quadrant == 3);
  CHECK(read->half == Half::kSecond);
  CHECK(datagramOf(RefereeCommand{Foul::kKickOff, TeamId::kYellow, 0, 0.0, Half::kFirst}) ==
        whole(1, 4) + whole(2, 1) + whole(5, 1));
  for (const unsigned field : {1U, 2U, 3U, 5U}) CHECK_FALSE(readRefereeCommand(whole(field, 100)));
}

TEST_CASE("the numbers of fouls and halves are the league's", "[unit]") {
  const Foul fouls[] = {Foul::kFreeKick, Foul::kPenaltyKick, Foul::kGoalKick, Foul::kFreeBall,
                        Foul::kKickOff,  Foul::kStop,        Foul::kGameOn,   Foul::kHalt};
  for (unsigned i = 1; i < 8; ++i) {
    CHECK(datagramOf(RefereeCommand{fouls[i], std::nullopt, 0, 0.0, Half::kNone}) ==
          whole(1, i) + whole(2, 2));
  }
  const Half halves[] = {Half::kNone,          Half::kFirst,          Half::kSecond,
                         Half::kOvertimeFirst, Half::kOvertimeSecond, Half::kShootOut};
  for (unsigned i = 1; i < 6; ++i) {
    CHECK(datagramOf(RefereeCommand{Foul::kFreeKick, TeamId::kBlue, 0, 0.0, halves[i]}) == whole(5, i));
  }
}

TEST_CASE("a placement is in degrees and of one team", "[unit]") {
  const TeamPlaces places{TeamId::kYellow, {{1, {{0.25, 0.5}, std::numbers::pi}}}};
  const std::string robot = whole(1, 1) + real(2, 0.25) + real(3, 0.5) + real(4, 180.0);
  const std::string expected = part(1, whole(1, 1) + part(2, robot));
  CHECK(datagramOf(places) == expected);
  const auto read = readTeamPlaces(expected);
  REQUIRE(read);
  CHECK(read->team == TeamId::kYellow);
  CHECK(read->robots.at(0).pose.heading == Approx(std::numbers::pi));
  CHECK_FALSE(readTeamPlaces(part(1, whole(1, 2))));  // neither team's
}

TEST_CASE("unknown fields are ignored, and what is no message is refused with its length", "[unit]") {
  CHECK(readPacket(real(15, 1.0)));
  const auto cut = readPacket(part(1, part(1, real(6, 1.0))).substr(0, 7));
  REQUIRE_FALSE(cut);
  CHECK(cut.error().code == ErrorCode::kBadInput);
  CHECK(cut.error().message == "7 bytes are no packet");
  const auto longest = readPacket(std::string(kLongestMessage + 1, '\0'));
  REQUIRE_FALSE(longest);
  CHECK(longest.error().message == "4097 bytes are too many for packet: at most 4096");
}

TEST_CASE("no bytes make a reader fail in any other way", "[unit]") {
  std::mt19937 random(1);
  const std::string good = datagramOf(someVision());
  for (int i = 0; i < 20'000; ++i) {
    std::string bytes = good.substr(0, random() % good.size());
    for (int flips = 0; flips < 3 && !bytes.empty(); ++flips) {
      bytes[random() % bytes.size()] = static_cast<char>(random());
    }
    const auto vision = readVision(bytes);
    if (vision) CHECK(readVision(datagramOf(*vision)));
    const auto packet = readPacket(bytes);
    if (packet) CHECK(readPacket(datagramOf(*packet)));
    (void)readTeamPlaces(bytes);
    (void)readRefereeCommand(bytes);
  }
}

}  // namespace fulbito::wire
