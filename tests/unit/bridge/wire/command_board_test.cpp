#include "bridge/wire/command_board.hpp"

#include <limits>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

namespace fulbito::wire {
namespace {

constexpr TeamId kBlue = TeamId::kBlue, kYellow = TeamId::kYellow;

Packet packetOf(std::vector<WheelCommand> commands) {
  Packet packet;
  packet.commands = std::move(commands);
  return packet;
}

OddityLog silentLog() {
  return OddityLog([] { return std::int64_t{0}; }, {});
}

}  // namespace

TEST_CASE("a command stays until the next one for the same robot, and packets may be partial", "[unit]") {
  CommandBoard board(3, false);
  OddityLog oddities = silentLog();
  CHECK(board.wheels(kBlue, 0).left == 0.0);
  board.take(packetOf({{0, kBlue, {560.0, -560.0}}}), 1, oddities);  // whatever the motors can do
  board.take(packetOf({{1, kBlue, {3.0, 4.0}}}), 1, oddities);       // one robot a datagram
  board.beginFrame();
  CHECK(board.wheels(kBlue, 0).left == 560.0);
  CHECK(board.wheels(kBlue, 1).right == 4.0);
  CHECK(board.wheels(kYellow, 0).left == 0.0);
  board.take(packetOf({{0, kBlue, {1.0, 2.0}}, {0, kBlue, {5.0, 6.0}}}), 2,
             oddities);  // any sender, the last
  CHECK(board.wheels(kBlue, 0).left == 5.0);
  CHECK(board.wheels(kBlue, 1).right == 4.0);
}

TEST_CASE("a command that is not finite is dropped and counted, and counts as an answer", "[unit]") {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  CommandBoard board(3, false);
  OddityLog oddities = silentLog();
  board.take(packetOf({{0, kYellow, {1.0, 2.0}}}), 1, oddities);
  board.beginFrame();
  board.take(packetOf({{0, kYellow, {kNan, 9.0}}, {1, kYellow, {9.0, -kInfinite}}, {2, kYellow, {7.0, 8.0}}}),
             1, oddities);
  CHECK(board.wheels(kYellow, 0).right == 2.0);
  CHECK(board.wheels(kYellow, 1).left == 0.0);
  CHECK(board.wheels(kYellow, 2).left == 7.0);
  CHECK(oddities.count(Oddity::kNotFinite) == 2);
  CHECK(board.answered(kYellow, 0b111));
}

TEST_CASE("robots that there are not are ignored and counted", "[unit]") {
  CommandBoard board(3, false);
  OddityLog oddities = silentLog();
  board.take(packetOf({{3, kBlue, {1.0, 1.0}}, {4'000'000'000U, kBlue, {1.0, 1.0}}}), 1, oddities);
  CHECK(oddities.count(Oddity::kUnknown) == 2);
  CHECK_FALSE(board.answering(kBlue));
}

TEST_CASE("a frame is answered once each robot asked for has a command", "[unit]") {
  CommandBoard board(3, false);
  OddityLog oddities = silentLog();
  board.take(packetOf({{0, kBlue, {}}}), 1, oddities);
  CHECK(board.answering(kBlue));
  CHECK_FALSE(board.answering(kYellow));
  CHECK_FALSE(board.answered(kBlue, 0b101));
  board.take(packetOf({{2, kBlue, {}}}), 1, oddities);
  CHECK(board.answered(kBlue, 0b101));
  board.beginFrame();
  CHECK_FALSE(board.answering(kBlue));
}

TEST_CASE("a locked server takes each colour from the first sender only", "[unit]") {
  CommandBoard board(3, true);
  OddityLog oddities = silentLog();
  board.take(packetOf({{0, kBlue, {1.0, 1.0}}}), 1, oddities);
  board.take(packetOf({{0, kBlue, {2.0, 2.0}}, {0, kYellow, {3.0, 3.0}}}), 2, oddities);
  board.take(packetOf({{0, kYellow, {4.0, 4.0}}}), 1, oddities);
  CHECK(board.wheels(kBlue, 0).left == 1.0);
  CHECK(board.wheels(kYellow, 0).left == 3.0);
  CHECK(oddities.count(Oddity::kOtherSender) == 2);
}

TEST_CASE("oddities are written once per kind and second, and all are counted", "[unit]") {
  std::int64_t time = 5;
  std::vector<std::string> lines;
  OddityLog oddities([&] { return time; }, [&](std::string_view line) { lines.emplace_back(line); });
  for (int i = 0; i < 1000; ++i) oddities.note(Oddity::kMalformed, "7 bytes");
  oddities.note(Oddity::kUnknown, "blue robot 9");
  time += 999'999'999;
  oddities.note(Oddity::kMalformed, "7 bytes");
  time += 1;
  oddities.note(Oddity::kMalformed, "8 bytes");
  CHECK(lines == std::vector<std::string>{"malformed datagram: 7 bytes (1 so far)",
                                          "unknown robot: blue robot 9 (1 so far)",
                                          "malformed datagram: 8 bytes (1002 so far)"});
  CHECK(oddities.count(Oddity::kMalformed) == 1002);
}

}  // namespace fulbito::wire
