#include "tests/unit/bridge/wire/bad_network.hpp"

#include <fmt/format.h>

#include "fulbito/match.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

namespace fulbito::wire {
namespace {

constexpr double kWheels = 4.0;  // [rad/s] the only command that the client ever gives

/// Commands of the first robot in play. Robots are held between a call and the signal.
struct CommandsSeen : MatchObserver {
  int moving = 0;   ///< ticks with the client's command
  int dropped = 0;  ///< ticks without it after the first one of the play that had it
  bool odd = false;
  bool moves = false;  ///< it had in this play
  void onPlayStart(const PlayStart&) override { moves = false; }
  void onTick(const MatchTick& tick) override {
    const double left = tick.commands.front().left;
    odd = odd || (left != kWheels && left != 0.0);
    if (left == kWheels) ++moving;
    if (left != kWheels && moves) ++dropped;
    moves = moves || left == kWheels;
  }
};

}  // namespace

TEST_CASE("a match ends, and commands stay in force, however bad the network is", "[unit]") {
  // A client that loses nothing always answers, however busy the machine is.
  const auto [loss, mode] = GENERATE(table<double, const char*>({{0.0, "lockstep=on,answer=2"},
                                                                 {0.1, "lockstep=on,answer=0.01"},
                                                                 {0.5, "lockstep=on,answer=0.01"},
                                                                 {0.5, "speed=20"}}));
  CAPTURE(loss, mode);
  const int port = test::freePortBase(), clients = test::freePortBase();
  auto config = MatchConfig::standard("idle", "idle");
  REQUIRE(config);
  TeamCatalogue catalogue;
  catalogue.addSource(wireTeams(test::outsideOptions(), {}));
  auto team = catalogue.parse(fmt::format("wire:blue@{}:interface=127.0.0.1,placing=0.5,{}", port, mode));
  REQUIRE(team);
  config->teams[0] = std::move(*team);
  config->rules.half_seconds = 2.0;
  const test::BadNetwork network(port, clients, loss);
  auto match = Match::create(*config, test::steadyTime);
  REQUIRE(match);
  test::TestClient client(clients, {[](const Vision&) {
                                      Packet packet;
                                      for (std::uint32_t i = 0; i < 3; ++i) {
                                        packet.commands.push_back({i, TeamId::kBlue, {kWheels, kWheels}});
                                      }
                                      return std::vector{datagramOf(packet)};
                                    },
                                    TeamPlaces{TeamId::kBlue, {}}});
  CommandsSeen seen;
  match->watch(seen);
  while (match->step()) {
  }
  client.stop();
  CHECK(match->referee().ended);
  CHECK_FALSE(match->faults().teams[0].forfeited);
  CHECK_FALSE(seen.odd);
  // One command that arrives is enough: it stays in force.
  CHECK(seen.moving > 0);
  CHECK(seen.dropped == 0);
  if (loss == 0.0) CHECK(match->faults().teams[0].late == 0);
}

}  // namespace fulbito::wire
