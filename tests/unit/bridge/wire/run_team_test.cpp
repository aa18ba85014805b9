#include "bridge/wire/run_team.hpp"

#include <algorithm>
#include <mutex>

#include <fmt/format.h>

#include "fulbito/match.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/team_memory.hpp"
#include "tests/unit/bridge/wire/test_client.hpp"

// These tests also run where the system refuses namespaces: see CMakeLists.txt.
namespace fulbito::wire {
namespace {

/// Lines that clients print.
struct Printed {
  std::mutex mutex;
  std::vector<std::string> lines;
  bool has(const std::string& line) {
    const std::lock_guard guard(mutex);
    return std::find(lines.begin(), lines.end(), line) != lines.end();
  }
};

OutsideOptions optionsFor(Printed& printed) {
  OutsideOptions options = test::outsideOptions();
  options.limits.memory = fulbito::test::kTeamMemory;
  options.log = [&printed](const std::string&, std::string_view line) {
    const std::lock_guard guard(printed.mutex);
    printed.lines.emplace_back(line);
  };
  return options;
}

Result<TeamChoice> choiceOf(const std::string& specification, const OutsideOptions& options) {
  TeamCatalogue catalogue = TeamCatalogue::builtIn();
  catalogue.addSource(wireTeams(options, {}));
  return catalogue.parse(specification);
}

Match matchOf(const std::string& blue, const std::string& yellow, const OutsideOptions& options) {
  auto config = MatchConfig::standard("idle", "idle");
  REQUIRE(config);
  for (const TeamId team : kTeams) {
    auto choice = choiceOf(team == TeamId::kBlue ? blue : yellow, options);
    INFO((choice ? std::string() : choice.error().message));
    REQUIRE(choice);
    config->teams[indexOf(team)] = std::move(*choice);
  }
  config->rules.half_seconds = 1.0;
  auto match = Match::create(*config, test::steadyTime);
  INFO((match ? std::string() : match.error().message));
  REQUIRE(match);
  return std::move(*match);
}

std::string running(const std::string& seat, const std::string& more = "", double answer = 10.0) {
  return fmt::format("wire:{}lockstep=on,answer={}:run={} {{colour}} {{port_base}}{}", seat, answer,
                     FULBITO_RUN_CLIENT, more);
}

bool hasOwnNetwork(const Match& match) {
  const auto& origin = match.config().teams[0].origin;
  return std::any_of(origin.begin(), origin.end(), [](const Setting& setting) {
    return setting.name == "containment" && setting.value.find("network-namespace") != std::string::npos;
  });
}

struct LastCommands : MatchObserver {
  std::vector<WheelSpeeds> commands;
  void onTick(const MatchTick& tick) override { commands.assign(tick.commands.begin(), tick.commands.end()); }
};

}  // namespace

TEST_CASE("clients that the match starts play it, side by side and with any colour", "[unit][run]") {
  Printed printed;
  const OutsideOptions options = optionsFor(printed);
  // Both are blue in networks of their own, where the ports are the league's.
  Match match = matchOf(running(""), running("blue:"), options);
  LastCommands watcher;
  match.watch(watcher);
  while (match.step()) {
  }
  for (const WheelSpeeds& wheels : watcher.commands) CHECK(wheels.left == 4.0);
  for (const TeamFaults& faults : match.faults().teams) {
    CHECK(faults.failures == 0);
    CHECK(faults.late == 0);
  }
  CHECK(match.referee().winner == std::nullopt);
  const bool own = hasOwnNetwork(match);
  CHECK(printed.has("a client of blue at 10002") == own);
  CHECK(printed.has("a client of blue at 21000") == !own);
}

TEST_CASE("a client that ends starts again, and loses once it has ended too often", "[unit][run]") {
  Printed printed;
  Match match = matchOf(running("yellow:", " 30", 0.1), "idle", optionsFor(printed));
  while (match.step()) {
  }
  const TeamFaults faults = match.faults().teams[0];
  CHECK(faults.failures == DecisionTime{}.failures);
  CHECK(faults.forfeited);
  CHECK(faults.failure == "its client ended: exit code 3");
  CHECK(match.referee().winner == TeamId::kYellow);
  CHECK(printed.has("it leaves"));
}

TEST_CASE("a client that does not start is refused before the match", "[unit][run]") {
  const auto refusal = [](const std::string& specification) {
    const auto choice = choiceOf(specification, test::outsideOptions());
    REQUIRE_FALSE(choice);
    CHECK(choice.error().code == ErrorCode::kUsage);
    return choice.error().message;
  };
  CHECK(refusal("wire:run=no-such-program").find("no-such-program") != std::string::npos);
  CHECK(refusal("wire:run=./no/such/file").find("./no/such/file") != std::string::npos);
  CHECK(refusal("wire:run= ").find("run= has no command") != std::string::npos);
}

TEST_CASE("a client needs a network of its own if the sandbox is required", "[unit][run]") {
  Printed printed;
  OutsideOptions options = optionsFor(printed);
  const bool own = hasOwnNetwork(matchOf(running(""), "idle", options));
  options.sandbox_required = true;
  const auto choice = choiceOf(running(""), options);
  CHECK(choice.has_value() == own);
  if (!choice) CHECK(choice.error().message.find("network-namespace") != std::string::npos);
}

}  // namespace fulbito::wire
