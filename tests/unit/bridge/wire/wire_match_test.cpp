#include <cmath>
#include <set>

#include <fmt/format.h>

#include "fulbito/match.hpp"
#include "fulbito/statistics.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

// Whole matches over real sockets on the loopback interface, at ports of their own.
namespace fulbito::wire {
namespace {

using test::TestClient;

constexpr double kHalf = 1.0;  // [s]

/// What the log of a server says.
struct Lines {
  std::vector<std::string> lines;
  WireLog log() {
    return [this](std::string_view line) { lines.emplace_back(line); };
  }
  bool has(const std::string& words) const {
    return std::any_of(lines.begin(), lines.end(),
                       [&](const std::string& line) { return line.find(words) != std::string::npos; });
  }
};

/// A match of these teams. Specifications of the wire have PORT and SET in place of the first port and of
/// settings for all.
MatchConfig configOf(const std::string& blue, const std::string& yellow, int port, WireLog log = {}) {
  auto config = MatchConfig::standard("idle", "idle");
  REQUIRE(config);
  TeamCatalogue catalogue = TeamCatalogue::builtIn();
  catalogue.addSource(wireTeams(test::outsideOptions(), std::move(log)));
  for (const TeamId team : kTeams) {
    const std::string& text = team == TeamId::kBlue ? blue : yellow;
    const std::string whole =
        isWire(text) ? fmt::format(fmt::runtime(text), port, "interface=127.0.0.1,speed=20") : text;
    auto choice = catalogue.parse(whole);
    INFO((choice ? std::string() : choice.error().message));
    REQUIRE(choice);
    config->teams[indexOf(team)] = std::move(*choice);
  }
  config->rules.half_seconds = kHalf;
  return *config;
}

Match matchOf(const MatchConfig& config) {
  auto match = Match::create(config, test::steadyTime);
  INFO((match ? std::string() : match.error().message));
  REQUIRE(match);
  return std::move(*match);
}

/// Commands for all robots of a team in one packet.
std::vector<std::string> driving(TeamId team, WheelSpeeds wheels) {
  Packet packet;
  for (std::uint32_t i = 0; i < 3; ++i) packet.commands.push_back({i, team, wheels});
  return {datagramOf(packet)};
}

/// Keeps where a robot stood at the beginning of each play, and the wheel speeds of the last tick.
struct Watcher : MatchObserver {
  std::vector<Placement> placements;
  std::vector<WheelSpeeds> commands;
  void onPlayStart(const PlayStart& start) override { placements.push_back(start.placement); }
  void onTick(const MatchTick& tick) override { commands.assign(tick.commands.begin(), tick.commands.end()); }
};

std::vector<RefereeCommand> commandsOf(const TestClient& client) {
  std::vector<RefereeCommand> read;
  for (const std::string& datagram : client.commands()) {
    CHECK_FALSE(datagram.empty());
    const auto command = readRefereeCommand(datagram);
    REQUIRE(command);
    read.push_back(*command);
  }
  return read;
}

/// A restart as yellow sees it, and what the referee says of it on the wire.
struct RestartCase {
  RestartKind kind;
  bool ours;
  Vec2 ball;  ///< in the frame of yellow, which is turned
  Foul foul;
  std::optional<TeamId> team;
  int quadrant;  ///< 0: none
};

std::vector<RestartCase> restartCases() {
  return {
      {RestartKind::kKickOff, true, {}, Foul::kKickOff, TeamId::kYellow, 0},
      {RestartKind::kPenalty, false, {-0.375, 0.0}, Foul::kPenaltyKick, TeamId::kBlue, 0},
      {RestartKind::kGoalKick, true, {-0.6, 0.3}, Foul::kGoalKick, TeamId::kYellow, 0},
      {RestartKind::kFreeKick, false, {-0.375, 0.0}, Foul::kFreeKick, TeamId::kBlue, 0},
      {RestartKind::kFreeBall, true, {-0.375, -0.4}, Foul::kFreeBall, std::nullopt, 1},
      {RestartKind::kFreeBall, true, {0.375, -0.4}, Foul::kFreeBall, std::nullopt, 2},
      {RestartKind::kFreeBall, false, {0.375, 0.4}, Foul::kFreeBall, std::nullopt, 3},
      {RestartKind::kFreeBall, false, {-0.375, 0.4}, Foul::kFreeBall, std::nullopt, 4},
  };
}

}  // namespace

TEST_CASE("a client plays a seat: its commands drive the robots, and its placement is obeyed", "[unit]") {
  const int port = test::freePortBase();
  const TeamId seat = GENERATE(TeamId::kBlue, TeamId::kYellow);  // of a client that is yellow on the wire
  const bool yellow_seat = seat == TeamId::kYellow;
  CAPTURE(nameOf(seat));
  const std::string wire = "wire:yellow@{}:{}";
  Match match = matchOf(configOf(yellow_seat ? "idle" : wire, yellow_seat ? wire : "idle", port));
  TestClient client(port, {[](const Vision&) { return driving(TeamId::kYellow, {6.0, -6.0}); },
                           TeamPlaces{TeamId::kYellow, {{1, {{0.6, 0.5}, 0.0}}, {9, {{0.1, 0.1}, 0.0}}}}});
  Watcher watcher;
  match.watch(watcher);
  while (match.step()) {
  }
  client.stop();
  CHECK(match.referee().ended);
  REQUIRE_FALSE(watcher.placements.empty());
  const Pose2 placed = *watcher.placements.front().robots[indexOf(seat)][1];
  const double side = yellow_seat ? 1.0 : -1.0;  // the frame is turned if the client plays the other seat
  CHECK(placed.position.x == Approx(side * 0.6).margin(0.01));
  CHECK(placed.position.y == Approx(side * 0.5).margin(0.01));
  CHECK(watcher.commands[yellow_seat ? 3 : 0].left == 6.0);
  CHECK(watcher.commands[yellow_seat ? 0 : 3].left == 0.0);
}

TEST_CASE("vision is what clients of the league rely on", "[unit]") {
  const int port = test::freePortBase();
  Match match = matchOf(configOf("wire:blue@{}:{}", "chaser", port));
  TestClient client(port, {[](const Vision&) { return driving(TeamId::kBlue, {3.0, 3.0}); }, {}});
  while (match.step()) {
  }
  client.stop();
  REQUIRE(client.frames().size() > 60);
  std::uint32_t step = 0;
  bool first = true;
  for (const std::string& datagram : client.frames()) {
    CHECK(datagram.size() <= kLongestVision);
    const auto vision = readVision(datagram);
    REQUIRE(vision);
    if (!first) CHECK(vision->step == step + 16);
    first = false;
    step = vision->step;
    CHECK(vision->ball_height > 0.02);
    for (const TeamId team : kTeams) {
      const auto& robots = vision->robots[indexOf(team)];
      REQUIRE(robots.size() == 3);
      for (std::uint32_t i = 0; i < 3; ++i) CHECK(robots[i].number == i);
    }
    CHECK(vision->field.length == 1.5);
    CHECK(vision->field.width == 1.3);
  }
  // Before the signal the robots stand where the rules place them: blue to the left.
  const auto start = readVision(client.frames().front());
  CHECK(start->robots[0][0].state.pose.position.x == Approx(-0.675).margin(0.01));
  CHECK(start->robots[1][0].state.pose.position.x == Approx(0.675).margin(0.01));
  CHECK(start->robots[1][0].state.velocity == Vec2{});
}

TEST_CASE("a robot that is off the field is left out of vision", "[unit]") {
  const int port = test::freePortBase();
  MatchConfig config = configOf("wire:blue@{}:{}", "idle", port);
  Placement start;
  start.ball = {0.3, 0.0};
  start.robots[0][0] = Pose2{{-0.5, 0.0}, 0.0};
  start.robots[0][2] = Pose2{{-0.5, 0.3}, 0.0};
  config.start = start;
  Match match = matchOf(config);
  TestClient client(port, {[](const Vision&) { return driving(TeamId::kBlue, {}); }, {}});
  while (match.step()) {
  }
  client.stop();
  REQUIRE_FALSE(client.frames().empty());
  const auto vision = readVision(client.frames().front());
  REQUIRE(vision->robots[0].size() == 2);
  CHECK(vision->robots[0][1].number == 2);
  CHECK(vision->robots[1].empty());
}

TEST_CASE("the referee says foul, stop and game on in this order, repeats them, and ends with halt",
          "[unit]") {
  const int port = test::freePortBase();
  Match match = matchOf(configOf("wire:blue@{}:{}", "idle", port));
  TestClient client(port, {[](const Vision&) { return driving(TeamId::kBlue, {}); }, {}});
  while (match.step()) {
  }
  client.stop();
  const auto commands = commandsOf(client);
  std::vector<Foul> told;
  for (const RefereeCommand& command : commands) {
    if (told.empty() || told.back() != command.foul) told.push_back(command.foul);
    CHECK(command.team.has_value() == (command.foul == Foul::kKickOff));
  }
  CHECK(told == std::vector<Foul>{Foul::kKickOff, Foul::kStop, Foul::kGameOn, Foul::kKickOff, Foul::kStop,
                                  Foul::kGameOn, Foul::kHalt});
  CHECK(commands.size() >= told.size() + 4);
  CHECK(commands.front().half == Half::kFirst);
  const auto second =
      std::find_if(commands.begin(), commands.end(), [](const auto& c) { return c.half == Half::kSecond; });
  REQUIRE(second != commands.end());
  CHECK(second->foul == Foul::kKickOff);
  CHECK(second->team != commands.front().team);
}

TEST_CASE("each restart has its foul, with the team that takes it or the ball's quadrant", "[unit]") {
  const int port = test::freePortBase();
  const MatchConfig config = configOf("wire:yellow@{}:{},placing=0", "idle", port);
  auto team = makeTeam(config.teams[0]);
  REQUIRE(team);
  MatchInfo info;
  info.field = config.field;
  info.rules = config.rules;
  (*team)->begin(info);
  TestClient client(port, {[](const Vision&) { return driving(TeamId::kYellow, {}); }, {}});
  const auto cases = restartCases();
  for (const RestartCase& c : cases) {
    PlacementRequest request;
    request.kind = c.kind;
    request.ours = c.ours;
    request.ball = c.ball;
    (*team)->place(request);
  }
  (*team)->ended({});
  client.stop();
  auto commands = commandsOf(client);
  // The first foul is repeated until there is a client.
  std::erase_if(commands, [&, first = true](const RefereeCommand& command) mutable {
    const bool again = !first && command.foul == Foul::kKickOff;
    first = false;
    return again;
  });
  REQUIRE(commands.size() > cases.size());
  for (std::size_t i = 0; i < cases.size(); ++i) {
    CAPTURE(i);
    CHECK(commands[i].foul == cases[i].foul);
    CHECK(commands[i].team == cases[i].team);
    CHECK(commands[i].quadrant == cases[i].quadrant);
  }
}

TEST_CASE("blue is on the left for clients, also when the teams change sides", "[unit]") {
  const int port = test::freePortBase();
  MatchConfig config = configOf("wire:blue@{}:{}", "idle", port);
  config.rules.periods.swap_sides = true;
  Match match = matchOf(config);
  TestClient client(port, {[](const Vision&) { return driving(TeamId::kBlue, {}); }, {}});
  while (match.step()) {
  }
  client.stop();
  CHECK(match.referee().blue_side == Side::kRight);
  REQUIRE_FALSE(client.frames().empty());
  for (const std::string& datagram : {client.frames().front(), client.frames().back()}) {
    const auto vision = readVision(datagram);
    CHECK(vision->robots[0][0].state.pose.position.x < 0.0);
    CHECK(vision->robots[1][0].state.pose.position.x > 0.0);
  }
}

TEST_CASE("two clients share one server, which shows each frame once", "[unit]") {
  const int port = test::freePortBase();
  Match match = matchOf(
      configOf("wire:blue@{}:{},lockstep=1,answer=10", "wire:yellow@{}:{},lockstep=1,answer=10", port));
  const auto client = [&](TeamId team) {
    // One robot a datagram.
    return TestClient::Behaviour{[team](const Vision&) {
                                   std::vector<std::string> datagrams;
                                   for (std::uint32_t i = 0; i < 3; ++i) {
                                     Packet packet;
                                     packet.commands.push_back({i, team, {2.0 + i, 2.0}});
                                     datagrams.push_back(datagramOf(packet));
                                   }
                                   return datagrams;
                                 },
                                 TeamPlaces{team, {}}};
  };
  TestClient blue(port, client(TeamId::kBlue)), yellow(port, client(TeamId::kYellow));
  Watcher watcher;
  match.watch(watcher);
  while (match.step()) {
  }
  blue.stop();
  yellow.stop();
  CHECK(blue.frames() == yellow.frames());
  CHECK(watcher.commands[2].left == 4.0);
  CHECK(watcher.commands[5].left == 4.0);
  CHECK(match.faults().teams[0].late == 0);
  std::set<std::uint32_t> steps;
  for (const std::string& datagram : blue.frames()) steps.insert(readVision(datagram)->step);
  CHECK(steps.size() == blue.frames().size());
}

TEST_CASE("after fast play in lockstep a restart takes no longer than its placements", "[unit]") {
  const int port = test::freePortBase();
  MatchConfig config = configOf("wire:blue@{}:{},lockstep=1,answer=10", "idle", port);
  config.rules.half_seconds = 10.0;
  Match match = matchOf(config);
  TestClient client(
      port, {[](const Vision&) { return driving(TeamId::kBlue, {}); }, TeamPlaces{TeamId::kBlue, {}}});
  const std::int64_t began = test::steadyTime();
  while (match.step()) {
  }
  client.stop();
  CHECK(match.referee().ended);
  CHECK(test::steadyTime() - began < 6'000'000'000);
}

TEST_CASE("a client of the teams' ports plays, whatever colour its commands name", "[unit]") {
  const int port = test::freePortBase();
  Match match = matchOf(configOf("wire:blue@{}:{},team_ports=on", "idle", port));
  auto sender = UdpSender::open({test::kLoopback, port + kBlueOffset}, test::kLoopback);
  REQUIRE(sender);
  TestClient client(port, {[&](const Vision&) {
                             sender->send(driving(TeamId::kYellow, {7.0, 7.0}).front());
                             return std::vector<std::string>{};
                           },
                           {}});
  Watcher watcher;
  match.watch(watcher);
  while (match.step()) {
  }
  client.stop();
  CHECK_FALSE(match.faults().teams[0].forfeited);
  CHECK(watcher.commands[0].left == 7.0);
}

TEST_CASE("in lockstep a client that falls silent is late, and a silent one loses in the end", "[unit]") {
  const int port = test::freePortBase();
  MatchConfig config = configOf("wire:blue@{}:{},lockstep=1,answer=0.001,wait=0.1", "idle", port);
  config.rules.half_seconds = 600.0;
  Match match = matchOf(config);
  std::atomic<int> answers{0};
  TestClient client(port, {[&](const Vision&) {
                             return ++answers < 40 ? driving(TeamId::kBlue, {3.0, 3.0})
                                                   : std::vector<std::string>{};
                           },
                           TeamPlaces{TeamId::kBlue, {}}});
  while (match.step()) {
  }
  client.stop();
  const TeamFaults faults = match.faults().teams[0];
  CHECK(faults.late > 0);
  CHECK(faults.forfeited);
  CHECK(faults.failure == "its client has said nothing for too long");
}

TEST_CASE("a match whose client never comes is lost by walk-over", "[unit]") {
  const int port = test::freePortBase();
  Lines lines;
  Match match = matchOf(configOf("idle", "wire:yellow@{}:{},wait=0.05", port, lines.log()));
  while (match.step()) {
  }
  CHECK(match.faults().teams[1].forfeited);
  CHECK(match.faults().teams[1].failure == "no client came");
  CHECK(match.referee().winner == TeamId::kBlue);
  CHECK(lines.has(fmt::format("waiting for a client of yellow: vision on 224.0.0.1:{}", port)));
}

TEST_CASE("garbage, floods and wishes of clients change nothing, and are counted", "[unit]") {
  const int port = test::freePortBase();
  Lines lines;
  Match match = matchOf(configOf("wire:blue@{}:{}", "idle", port, lines.log()));
  TestClient client(port, {[](const Vision&) {
                             Packet wishes;
                             wishes.ball = BallReplacement{{0.7, 0.0}, {5.0, 0.0}};
                             wishes.robots = {{0, TeamId::kYellow, {}, false}};
                             auto datagrams = driving(TeamId::kBlue, {5.0, 5.0});
                             datagrams.insert(datagrams.end(),
                                              {datagramOf(wishes), "garbage", "", std::string(5000, 'x')});
                             return datagrams;
                           },
                           {}});
  // Floods from a socket of its own.
  TestClient flood(port, {[](const Vision&) { return std::vector<std::string>(300, "no message"); }, {}});
  Watcher watcher;
  match.watch(watcher);
  while (match.step()) {
  }
  client.stop();
  flood.stop();
  CHECK(match.referee().score == PerTeam<int>{0, 0});
  CHECK(watcher.commands[0].left == 5.0);
  CHECK(lines.has("malformed datagram: "));
  CHECK(lines.has("datagram of a flood: "));
  CHECK(lines.has("replacement, which is the referee's: "));
  CHECK(lines.lines.size() < 40);
}

TEST_CASE("teams that cannot share their ports are refused before the match", "[unit]") {
  const int port = test::freePortBase();
  const auto refusal = [&](const char* blue, const char* yellow) {
    const auto match = Match::create(configOf(blue, yellow, port), test::steadyTime);
    return match ? std::string() : match.error().message;
  };
  CHECK(refusal("wire:blue@{}:{}", "wire:yellow@{}:{}").empty());
  CHECK(refusal("wire:blue@{}:{}", "wire:blue@{}:{}").find("plays already") != std::string::npos);
  CHECK(refusal("wire:blue@{}:{}", "wire:yellow@{}:{},wait=3").find("the same settings") !=
        std::string::npos);
  const auto taken = UdpReceiver::open({"", port + kCommandOffset}, test::kLoopback);
  REQUIRE(taken);
  TeamCatalogue catalogue;
  catalogue.addSource(wireTeams(test::outsideOptions(), {}));
  const auto choice = catalogue.parse(fmt::format("wire:blue@{}:interface=127.0.0.1", port));
  REQUIRE_FALSE(choice);
  CHECK(choice.error().code == ErrorCode::kIo);
  CHECK(choice.error().message.find(fmt::format("port {}", port + kCommandOffset)) != std::string::npos);
}

}  // namespace fulbito::wire
