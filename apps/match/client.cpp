#include "apps/match/client.hpp"

#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "apps/common/commands.hpp"
#include "apps/common/console.hpp"
#include "apps/common/option_values.hpp"
#include "apps/match/league_player.hpp"
#include "bridge/wire/wire_client.hpp"

namespace fulbito::app {
namespace {

constexpr double kLook = 0.05;       // [s] between looks for signals while nothing comes
constexpr double kAfterHalt = 0.25;  // [s] without a frame after a halt: the match is over

/// What came and went on the wire.
struct Traffic {
  std::int64_t skipped = 0;
  std::int64_t malformed = 0;
  std::int64_t unsent = 0;
};

/// Plays until the server is gone or a signal comes. Errors: as `LeaguePlayer::play`.
Result<void> playUntilEnd(wire::WireClient& wire, LeaguePlayer& player, const ClientCommand& options,
                          Traffic& traffic) {
  std::optional<std::int64_t> seen_at;
  while (!interrupted()) {
    const wire::Heard heard = wire.listen(kLook);
    traffic.malformed += heard.malformed;
    for (const wire::RefereeCommand& command : heard.commands) {
      const auto places = player.take(command);
      if (places && !wire.send(*places)) ++traffic.unsent;
    }
    if (!heard.frames.empty()) {
      seen_at = now();
      traffic.skipped += static_cast<std::int64_t>(heard.frames.size()) - 1;
      const auto packet = player.play(heard.frames.back().vision);
      if (!packet) return tl::unexpected<Error>(packet.error());
      if (!wire.send(*packet)) ++traffic.unsent;
    } else if (seen_at) {
      const double silent = static_cast<double>(now() - *seen_at) * 1e-9;
      if (silent > (player.halted() && !options.stay ? kAfterHalt : options.patience)) return {};
    }
  }
  return {};
}

void print(const ClientCommand& options, const LeaguePlayer& player, const Traffic& traffic) {
  const PerTeam<int> score = player.score();
  const TeamFaults& faults = player.faults();
  if (options.json) {
    const nlohmann::ordered_json json = {{"schema_version", 1},
                                         {"team", options.settings.blue},
                                         {"colour", options.colour},
                                         {"score", {{"blue", score[0]}, {"yellow", score[1]}}},
                                         {"halted", player.halted()},
                                         {"play_s", player.playSeconds()},
                                         {"frames", player.counts().frames},
                                         {"skipped", traffic.skipped},
                                         {"placements", player.counts().placements},
                                         {"late", faults.late},
                                         {"saturated", faults.saturated},
                                         {"malformed", traffic.malformed + player.counts().odd},
                                         {"unsent", traffic.unsent}};
    writeOut(json.dump(2) + "\n");
    return;
  }
  say("{} played {} for {:.1f} s; blue {} : {} yellow by the server's count\n", options.settings.blue,
      options.colour, player.playSeconds(), score[0], score[1]);
  say("frames answered {}, skipped {}; placements {}; late decisions {}; malformed datagrams {}\n",
      player.counts().frames, traffic.skipped, player.counts().placements, faults.late,
      traffic.malformed + player.counts().odd);
}

Result<MatchConfig> matchOf(const ClientCommand& options, TeamId team) {
  auto config = configWithoutTeams(options.settings);
  if (!config) return config;
  auto own = catalogueOf(options.settings.outside).parse(options.settings.blue);
  auto nobody = parseTeam("idle");
  if (!own) return tl::unexpected<Error>(own.error());
  if (!nobody) return tl::unexpected<Error>(nobody.error());
  config->teams[indexOf(team)] = std::move(*own);
  config->teams[indexOf(other(team))] = std::move(*nobody);
  config->vision[indexOf(team)].latency_ticks = options.latency;
  return config;
}

}  // namespace

CLI::App* addClient(CLI::App& app, ClientCommand& options) {
  options.settings.robot = "firasim";
  CLI::App* command =
      app.add_subcommand("client", "play a team as a client of the league's simulator or of fulbito serve");
  command->footer(
      "Examples:\n"
      "  fulbito client libero --colour blue                    on the league's simulator, with its referee\n"
      "  fulbito client 'cmd:python3 team.py' --colour yellow --interface 127.0.0.1\n"
      "It ends with the match of fulbito serve, and otherwise once vision has stopped, or with Ctrl-C.\n"
      "More: docs/league.md.");
  command->add_option("team", options.settings.blue, "team that plays")->capture_default_str();
  command->add_option("--colour", options.colour, "colour of its robots")
      ->check(CLI::IsMember({"blue", "yellow"}))
      ->capture_default_str();
  const auto group = [](CLI::Option* option) { return option->group("Server"); };
  group(command->add_option("--host", options.host, "address of the server"))
      ->type_name("ADDRESS")
      ->capture_default_str();
  group(wholeNumber(command->add_option("--port-base", options.port_base,
                                        "port of vision; the others follow as in fulbito serve"),
                    1, wire::kLargestPortBase))
      ->type_name("N")
      ->capture_default_str();
  group(command->add_option("--interface", options.interface,
                            "address of the interface for multicast (default: the system's choice)"))
      ->type_name("ADDRESS");
  group(wholeNumber(command->add_option("--latency", options.latency,
                                        "frames until commands act, beyond the next: 1 on the league's "
                                        "simulator, 0 here"),
                    0, kMaxLatencyTicks))
      ->type_name("N")
      ->capture_default_str();
  group(number(command->add_option("--patience", options.patience,
                                   "time without vision after which the match is over [s]")))
      ->check(CLI::Range(0.1, 86400.0))
      ->type_name("S")
      ->capture_default_str();
  group(command->add_flag("--stay", options.stay, "HALT does not end it: another match may follow"));
  command->add_option("--rules", options.settings.rules, "rules profile or TOML file")->capture_default_str();
  command->add_option("--physics", options.settings.physics, "physics profile or TOML file")
      ->capture_default_str();
  command->add_option("--robot", options.settings.robot, "robots of the server, a preset or TOML file")
      ->capture_default_str();
  addSeed(*command, options.settings.seed, "the team's own numbers");
  addTeamFlags(*command, options.settings.outside);
  command->add_flag("--json", options.json, "print JSON");
  return command;
}

int client(const ClientCommand& options) {
  const TeamId team = options.colour == nameOf(TeamId::kYellow) ? TeamId::kYellow : TeamId::kBlue;
  const auto config = matchOf(options, team);
  if (!config) return report(config.error());
  auto wire = wire::WireClient::open(options.host, options.port_base, options.interface);
  if (!wire) return report(wire.error());
  auto player = LeaguePlayer::create(*config, team, now);
  if (!player) return report(player.error());
  note("waiting for vision on {}:{}\n", wire::kVisionGroup, options.port_base + wire::kVisionOffset);
  Traffic traffic;
  const auto played = playUntilEnd(*wire, *player, options, traffic);
  player->end();
  print(options, *player, traffic);
  if (!played) {
    const int code = report(played.error());
    return player->faults().forfeited ? kTeamFailed : code;
  }
  return interrupted() ? interruptedCode() : kOk;
}

}  // namespace fulbito::app
