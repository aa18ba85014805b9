#include <algorithm>
#include <array>
#include <set>

#include "bridge/wire/wire_server.hpp"
#include "bridge/wire/wire_team.hpp"
#include "fulbito/match.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

// What the league's simulator has sent, beside what is sent here on the same motion (recorded/README.md).
namespace fulbito::wire {
namespace {

constexpr std::size_t kFrames = 1000;

unsigned byteAt(std::string_view bytes, std::size_t at) { return static_cast<unsigned char>(bytes.at(at)); }

std::vector<std::string> recordedFrames() {
  const std::string all = fulbito::test::contentOf(FULBITO_RECORDED_VISION);
  std::vector<std::string> frames;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t size = byteAt(all, at) + 256U * byteAt(all, at + 1);
    frames.push_back(all.substr(at + 2, size));
    at += 2 + size;
  }
  REQUIRE(frames.size() == kFrames);
  return frames;
}

std::uint64_t readWhole(std::string_view bytes, std::size_t& at) {
  std::uint64_t value = 0;
  for (unsigned shift = 0;; shift += 7) {
    const unsigned byte = byteAt(bytes, at++);
    value |= static_cast<std::uint64_t>(byte & 0x7fU) << shift;
    if (byte < 0x80) return value;
  }
}

/// Adds the fields of a message that have a number, by the numbers of the fields that lead to them: "2.3.1"
/// is a blue robot's id. Known are whole numbers, doubles and messages.
void addPaths(std::string_view bytes, const std::string& prefix, std::set<std::string>& paths) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::uint64_t key = readWhole(bytes, at);
    const std::string path = prefix + std::to_string(key / 8);
    if (key % 8 == 2) {
      const auto size = static_cast<std::size_t>(readWhole(bytes, at));
      addPaths(bytes.substr(at, size), path + ".", paths);
      at += size;
      continue;
    }
    REQUIRE(key % 8 <= 1);
    paths.insert(path);
    if (key % 8 == 0) readWhole(bytes, at);
    if (key % 8 == 1) at += sizeof(double);
  }
}

/// The fields that any of the messages has.
std::set<std::string> pathsOf(const std::vector<std::string>& datagrams) {
  std::set<std::string> paths;
  for (const std::string& datagram : datagrams) addPaths(datagram, "", paths);
  return paths;
}

/// A frame as blue observes it.
Observation observationOf(const Vision& vision) {
  Observation observation;
  observation.tick = vision.step / 16;
  observation.ball = vision.ball;
  for (const SeenRobot& robot : vision.robots[0]) observation.own.at(robot.number) = {true, robot.state};
  for (const SeenRobot& robot : vision.robots[1])
    observation.opponents.at(robot.number) = {true, robot.state};
  return observation;
}

/// The team of one client, and what that client hears.
struct Stage {
  Stage() {
    WireSettings settings;
    settings.interface = test::kLoopback;
    settings.port_base = test::freePortBase();
    auto server = WireServer::open(settings, test::steadyTime, {});
    REQUIRE(server);
    team = std::make_unique<WireTeam>(std::shared_ptr<WireServer>(std::move(*server)), TeamId::kBlue, false);
    team->begin(MatchInfo{});
    auto heard = UdpReceiver::open({kVisionGroup, settings.port_base + kVisionOffset}, test::kLoopback);
    REQUIRE(heard);
    vision = std::make_unique<UdpReceiver>(std::move(*heard));
  }
  std::string shown(const Observation& observation) {
    team->ask(observation);
    waitForAny(std::array{vision->number()}, 5.0);
    std::array<char, kLongestMessage> room{};
    const auto datagram = vision->receive(room);
    return datagram ? std::string(room.data(), datagram->size) : std::string();
  }
  std::unique_ptr<WireTeam> team;
  std::unique_ptr<UdpReceiver> vision;
};

}  // namespace

TEST_CASE("frames of the league's simulator are the same bytes once read and written", "[unit]") {
  std::size_t longest = 0, without_two = 0;
  for (const std::string& datagram : recordedFrames()) {
    const auto vision = readVision(datagram);
    REQUIRE(vision);
    CHECK(datagramOf(*vision) == datagram);
    longest = std::max(longest, datagram.size());
    if (vision->robots[0].size() == 2 && vision->robots[1].size() == 2) ++without_two;
  }
  CHECK(longest == 471);
  CHECK(without_two == 100);
}

TEST_CASE("a match sends what the league's simulator sent on the same motion", "[unit]") {
  Stage stage;
  for (const std::string& datagram : recordedFrames()) {
    auto vision = readVision(datagram);
    REQUIRE(vision);
    const std::string shown = stage.shown(observationOf(*vision));
    // The league's ball falls and rolls in three dimensions; here it stays on the ground.
    vision->ball_height = BallModel{}.radius;
    CHECK(shown == datagramOf(*vision));
  }
}

TEST_CASE("vision of a match has the fields of the league's simulator, and its field's sizes", "[unit]") {
  const std::vector<std::string> recorded = recordedFrames();
  auto config = MatchConfig::standard("idle", "chaser");
  REQUIRE(config);
  TeamCatalogue catalogue;
  catalogue.addSource(wireTeams(test::outsideOptions(), {}));
  const int port = test::freePortBase();
  auto team = catalogue.parse("wire:blue@" + std::to_string(port) + ":interface=127.0.0.1,speed=20");
  REQUIRE(team);
  config->teams[0] = std::move(*team);
  config->rules.half_seconds = 3.0;
  auto match = Match::create(*config, test::steadyTime);
  REQUIRE(match);
  test::TestClient client(port, {[](const Vision&) {
                                   Packet packet;
                                   packet.commands = {{0, TeamId::kBlue, {9.0, 3.0}},
                                                      {1, TeamId::kBlue, {4.0, 9.0}},
                                                      {2, TeamId::kBlue, {-7.0, 5.0}}};
                                   return std::vector{datagramOf(packet)};
                                 },
                                 {}});
  while (match->step()) {
  }
  client.stop();
  std::set<std::string> paths = pathsOf(client.frames());
  for (const char* goals : {"4", "5"}) paths.erase(goals);  // the league's simulator counts none
  CHECK(paths == pathsOf(recorded));
  const auto ours = readVision(client.frames().at(0)), theirs = readVision(recorded.at(0));
  CHECK(ours->field.width == theirs->field.width);
  CHECK(ours->field.length == theirs->field.length);
  CHECK(ours->field.goal_width == theirs->field.goal_width);
  CHECK(ours->field.goal_depth == theirs->field.goal_depth);
  CHECK(ours->field.centre_circle_radius == theirs->field.centre_circle_radius);
  CHECK(ours->field.goal_area_width == theirs->field.goal_area_width);
  CHECK(ours->field.goal_area_depth == theirs->field.goal_area_depth);
  CHECK(ours->field.penalty_mark == theirs->field.penalty_mark);
}

}  // namespace fulbito::wire
