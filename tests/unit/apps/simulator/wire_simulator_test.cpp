#include "apps/simulator/wire_simulator.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

// Over real sockets on the loopback interface. Packets are sent between two frames.
namespace fulbito::simulator {
namespace {

using wire::Oddity;
using wire::Packet;
using wire::test::kLoopback;

/// A simulator, and all that one can send it.
struct Bench {
  wire::WireSettings settings;
  std::unique_ptr<WireSimulator> simulator;
  std::optional<wire::UdpReceiver> vision, referee;

  explicit Bench(bool team_ports = false, bool lockstep = false) {
    settings.interface = kLoopback;
    settings.port_base = wire::test::freePortBase();
    settings.speed = 20.0;
    settings.team_ports = team_ports;
    settings.lockstep = lockstep;
    auto config = MatchConfig::standard("idle", "idle");
    config->robot = *loadRobot("firasim");
    auto opened = WireSimulator::open(*config, settings, wire::test::steadyTime, {});
    REQUIRE(opened);
    simulator = std::move(*opened);
    vision = listenAt(wire::kVisionGroup, wire::kVisionOffset);
    referee = listenAt(wire::kRefereeGroup, wire::kRefereeOffset);
  }
  wire::UdpReceiver listenAt(const char* group, int offset) const {
    auto opened = wire::UdpReceiver::open({group, settings.port_base + offset}, kLoopback);
    REQUIRE(opened);
    return std::move(*opened);
  }
  void send(std::string_view datagram, int offset = wire::kCommandOffset) const {
    auto sender = wire::UdpSender::open({kLoopback, settings.port_base + offset}, kLoopback);
    REQUIRE(sender);
    CHECK(sender->send(datagram));
  }
  void send(const Packet& packet, int offset = wire::kCommandOffset) const {
    send(wire::datagramOf(packet), offset);
  }
  void run(int frames) {
    for (int i = 0; i < frames; ++i) REQUIRE(simulator->step());
  }
  /// All frames that came since the last call.
  std::vector<wire::Vision> frames() {
    std::vector<wire::Vision> read;
    std::array<char, wire::kLongestVision> room{};
    while (const auto datagram = vision->receive(room)) {
      auto frame = wire::readVision({room.data(), datagram->size});
      REQUIRE(frame);
      read.push_back(std::move(*frame));
    }
    return read;
  }
  /// The newest of them after one more.
  wire::Vision seen() {
    run(1);
    auto all = frames();
    REQUIRE_FALSE(all.empty());
    return all.back();
  }
  std::uint64_t count(Oddity kind) const { return simulator->server().oddities().count(kind); }
};

Packet driving(std::uint32_t number, TeamId team, WheelSpeeds wheels) {
  Packet packet;
  packet.commands.push_back({number, team, wheels});
  return packet;
}

Packet putting(std::uint32_t number, TeamId team, const Pose2& pose, bool on = true) {
  Packet packet;
  packet.robots.push_back({number, team, pose, on});
  return packet;
}

}  // namespace

TEST_CASE("without a referee vision goes out each frame, and nobody speaks as the referee", "[unit]") {
  Bench bench;
  bench.run(10);
  const auto frames = bench.frames();
  REQUIRE(frames.size() == 10);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    CHECK(frames[i].step == 16 * (i + 1));
    CHECK(frames[i].robots[0].size() == 3);
    CHECK(frames[i].robots[1].size() == 3);
    CHECK(frames[i].goals == PerTeam<std::uint32_t>{});
  }
  std::array<char, 64> room{};
  CHECK_FALSE(bench.referee->receive(room));
  CHECK(bench.simulator->server().frames() == 10);
}

TEST_CASE("commands drive the robots at once and stay in force", "[unit]") {
  Bench bench;
  bench.send(driving(1, TeamId::kYellow, {20.0, 20.0}));
  bench.run(40);
  const wire::Vision seen = bench.seen();
  CHECK(seen.robots[1][1].state.velocity.x < -0.3);  // it faces blue's goal
  CHECK(seen.robots[1][2].state.velocity == Vec2{});
  CHECK(bench.simulator->server().commands() == 1);
}

TEST_CASE("a goal restarts nothing and counts for nobody", "[unit]") {
  Bench bench;
  Packet shot = putting(0, TeamId::kYellow, {{0.5, 0.5}, 0.0});
  shot.ball = wire::BallReplacement{{0.6, 0.0}, {1.0, 0.0}};
  bench.send(shot);
  bench.run(15);
  const wire::Vision seen = bench.seen();
  CHECK(seen.ball.position.x > 0.76);
  CHECK(seen.goals == PerTeam<std::uint32_t>{});
  CHECK(bench.simulator->replacements() == 2);
}

TEST_CASE("replacements are in degrees, and keep the command that is in force", "[unit]") {
  Bench bench;
  // Field by field as the original referee writes it: robot 0 of yellow at (0.1, 0.2), 90 degrees, on.
  const std::string bytes(
      "\x12\x23\x12\x21\x0a\x1b\x11\x9a\x99\x99\x99\x99\x99\xb9\x3f\x19\x9a\x99\x99\x99\x99\x99\xc9\x3f\x21"
      "\x00\x00\x00\x00\x00\x80\x56\x40\x28\x01\x30\x01",
      37);
  bench.send(driving(0, TeamId::kYellow, {20.0, 20.0}));
  bench.run(30);
  bench.send(bytes);
  bench.run(1);
  const RobotState placed = bench.seen().robots[1][0].state;
  CHECK(placed.pose.position.x == Approx(0.1).margin(0.02));
  CHECK(placed.pose.position.y == Approx(0.2).margin(0.02));
  CHECK(placed.pose.heading == Approx(math::kPi / 2).margin(0.05));
  CHECK(placed.velocity.x < -0.05);  // as before, though the robot looks elsewhere now
  bench.run(30);
  CHECK(bench.seen().robots[1][0].state.velocity.y > 0.3);
}

TEST_CASE("a packet's commands come before its replacements", "[unit]") {
  Bench bench;
  Packet both = driving(0, TeamId::kBlue, {20.0, 20.0});
  both.robots.push_back({0, TeamId::kBlue, {{-0.5, 0.4}, 0.0}, false});
  both.robots.push_back({1, TeamId::kBlue, {{-0.5, -0.4}, 0.0}, true});
  both.commands.push_back({1, TeamId::kBlue, {20.0, 20.0}});
  bench.send(both);
  bench.run(30);
  // The robot that went off has lost its command, the other one drives.
  bench.send(putting(0, TeamId::kBlue, {{-0.5, 0.4}, 0.0}));
  bench.run(30);
  const wire::Vision seen = bench.seen();
  CHECK(seen.robots[0][0].state.velocity == Vec2{});
  CHECK(seen.robots[0][1].state.velocity.x > 0.3);
}

TEST_CASE("a robot is off until a replacement turns it on", "[unit]") {
  Bench bench;
  // Robot 0 of blue at the centre: with no field at all, and so not turned on.
  bench.send(std::string("\x12\x02\x12\x00", 4));
  bench.run(1);
  REQUIRE(bench.seen().robots[0].size() == 2);
  bench.send(driving(0, TeamId::kBlue, {20.0, 20.0}));
  bench.run(20);
  CHECK(bench.seen().robots[0].front().number == 1);
  bench.send(putting(0, TeamId::kBlue, {{-0.5, 0.4}, 0.0}));
  bench.run(1);
  CHECK(bench.seen().robots[0].size() == 3);
  // The command came while it was off, and is in force now.
  bench.run(30);
  CHECK(bench.seen().robots[0][0].state.velocity.x > 0.3);
}

TEST_CASE("without a referee oddities are dropped and counted, too", "[unit]") {
  Bench bench;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  bench.send("garbage");
  bench.send(putting(7, TeamId::kBlue, {}));
  bench.send(putting(0, TeamId::kBlue, {{nan, 0.0}, 0.0}, false));
  bench.send(driving(0, TeamId::kBlue, {nan, 1.0}));
  bench.run(2);
  CHECK(bench.count(Oddity::kMalformed) == 1);
  CHECK(bench.count(Oddity::kUnknown) == 1);
  CHECK(bench.count(Oddity::kNotFinite) == 2);
  CHECK(bench.simulator->replacements() == 0);
  CHECK(bench.seen().robots[0].size() == 3);
}

TEST_CASE("at the teams' ports the port says whose commands they are", "[unit]") {
  Bench bench(true);
  bench.send(driving(0, TeamId::kBlue, {20.0, 20.0}), wire::kYellowOffset);
  bench.send(driving(1, TeamId::kYellow, {20.0, 20.0}), wire::kBlueOffset);
  bench.send(driving(2, TeamId::kBlue, {20.0, 20.0}));
  bench.send(putting(2, TeamId::kYellow, {}, false), wire::kYellowOffset);
  bench.run(20);
  const wire::Vision seen = bench.seen();
  const std::vector<std::vector<bool>> moving{{false, true, true}, {true, false, false}};
  for (std::size_t team = 0; team < 2; ++team) {
    REQUIRE(seen.robots[team].size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
      CHECK((norm(seen.robots[team][i].state.velocity) > 0.2) == moving[team][i]);
    }
  }
  CHECK(bench.count(Oddity::kReplacement) == 1);
}

TEST_CASE("in lockstep a frame waits for the colours that have a client", "[unit]") {
  Bench bench(false, true);
  const auto began = wire::test::steadyTime();
  {
    wire::test::TestClient client(bench.settings.port_base,
                                  {[](const wire::Vision&) {
                                     Packet packet;
                                     for (std::uint32_t i = 0; i < 3; ++i)
                                       packet.commands.push_back({i, TeamId::kBlue, {5.0, 5.0}});
                                     return std::vector{wire::datagramOf(packet)};
                                   },
                                   {}});
    bench.run(600);
  }
  const double seconds = static_cast<double>(wire::test::steadyTime() - began) * 1e-9;
  INFO(seconds);
  CHECK(seconds < 5.0);  // 10 s simulated
  CHECK(bench.simulator->server().commands() > 1500);
}

}  // namespace fulbito::simulator
