#include "apps/match/serve.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/commands.hpp"
#include "apps/common/option_values.hpp"

namespace fulbito::app {
namespace {

constexpr const char* kClient = "a client";  // of the league: the default of both teams

/// The specification of the client of that colour.
std::string clientOf(TeamId colour, const wire::WireSettings& settings) {
  std::string text = fmt::format("wire:{}", nameOf(colour));
  if (settings.port_base != wire::kDefaultPortBase) text += fmt::format("@{}", settings.port_base);
  text += fmt::format(":wait={}", settings.wait);
  if (!settings.interface.empty()) text += fmt::format(",interface={}", settings.interface);
  if (settings.speed != 1.0) text += fmt::format(",speed={}", settings.speed);
  if (settings.lockstep) text += fmt::format(",lockstep=on,answer={}", settings.answer);
  if (settings.placing != wire::WireSettings{}.placing) text += fmt::format(",placing={}", settings.placing);
  if (settings.lock) text += ",lock=on";
  if (settings.team_ports) text += ",team_ports=on";
  return text;
}

void addWire(CLI::App& command, wire::WireSettings& wire) {
  const auto group = [](CLI::Option* option) { return option->group("Clients"); };
  group(wholeNumber(command.add_option("--port-base", wire.port_base,
                                       "port of vision; the others follow from it: docs/league.md"),
                    1, wire::kLargestPortBase)
            ->type_name("PORT")
            ->capture_default_str());
  group(command
            .add_option("--interface", wire.interface,
                        "address of the interface for multicast (default: the system's choice)")
            ->type_name("ADDRESS"));
  CLI::Option* speed = group(number(command.add_option("--speed", wire.speed, "pace over real time"))
                                 ->check(CLI::Range(0.1, 20.0))
                                 ->type_name("NUMBER")
                                 ->capture_default_str());
  CLI::Option* lockstep = group(command.add_flag(
      "--lockstep", wire.lockstep, "the next frame follows as soon as the clients have answered this one"));
  lockstep->excludes(speed);
  group(number(command.add_option("--answer", wire.answer, "with --lockstep: longest wait for an answer [s]"))
            ->check(CLI::Range(0.001, 60.0))
            ->type_name("S")
            ->needs(lockstep)
            ->capture_default_str());
  group(number(command.add_option("--placing", wire.placing,
                                  "longest wait for placements at a restart [s], over --speed"))
            ->check(CLI::Range(0.0, 60.0))
            ->type_name("S")
            ->capture_default_str());
  group(
      number(command.add_option("--wait", wire.wait,
                                "time without a client after which its team forfeits [s]; 0: it never does"))
          ->check(CLI::Range(0.0, 86400.0))
          ->type_name("S")
          ->capture_default_str());
  group(command.add_flag("--lock", wire.lock,
                         "for each colour only the first sender counts; otherwise all do"));
  group(command.add_flag("--team-ports", wire.team_ports,
                         "commands also come at ports 20012, yellow, and 20013, blue, as TraveSim has them"));
}

/// Options that need the referee of `serve` exclude `--no-referee`.
void addAlone(CLI::App& command, ServeCommand& options) {
  const auto group = [](CLI::Option* option) { return option->group("Without a referee"); };
  CLI::Option* alone =
      group(command.add_flag("--no-referee", options.no_referee,
                             "simulate only, without a match: any sender may move robots and ball"));
  for (const char* other : {"--placing", "--wait", "--half-seconds", "--events", "--time", "--latency",
                            "--noise", "--dropout", "--view"}) {
    alone->excludes(command.get_option(other));
  }
  group(number(command.add_option("--seconds", options.alone.seconds,
                                  "with --no-referee: simulated time until the end [s] (default: Ctrl-C)")))
      ->check(CLI::Range(0.01, 1e6))
      ->type_name("S")
      ->needs(alone);
}

/// What is no option of `--no-referee` but has a substitute.
Result<void> checkAlone(const ServeCommand& options) {
  const MatchSettings& settings = options.match.settings;
  if (settings.blue != kClient || settings.yellow != kClient) {
    return fail(ErrorCode::kUsage,
                "serve: --no-referee has no teams of its own; start each as a client: fulbito client libero "
                "--colour blue");
  }
  if (!options.match.record.empty()) {
    return fail(ErrorCode::kUsage,
                "serve: --no-referee has no match to record; fulbito record listens to vision and writes a "
                "recording");
  }
  return {};
}

}  // namespace

CLI::App* addServe(CLI::App& app, ServeCommand& options) {
  options.match.settings.blue = options.match.settings.yellow = kClient;
  options.match.settings.robot = "firasim";
  options.wire.wait = 0.0;
  CLI::App* command = app.add_subcommand("serve", "play a match with clients of the league's simulator");
  command->footer(
      "Examples:\n"
      "  fulbito serve                                          two clients, at the league's addresses\n"
      "  fulbito serve --yellow libero --interface 127.0.0.1    a client that is blue, against libero\n"
      "  fulbito serve --lockstep --record game.fbr --json      as fast as the clients are\n"
      "  fulbito serve --view --yellow libero                   watch it\n"
      "  fulbito serve --port-base 11000                        a second server on the same machine\n"
      "  fulbito serve --no-referee                             for the league's own referee program\n"
      "A client is a team of all other commands, too: fulbito match libero wire:yellow. More: "
      "docs/league.md.");
  MatchCommand& match = options.match;
  command->add_option("--blue", match.settings.blue, "team that plays blue")->capture_default_str();
  command->add_option("--yellow", match.settings.yellow, "team that plays yellow")->capture_default_str();
  addWire(*command, options.wire);
  addMatchSettings(*command, match.settings);
  addMatchOutputs(*command, match);
  CLI::Option* view = command->add_flag("--view", match.view, "show the match in a window");
  addViewOptions(*command, match.window, view, false);
  addAlone(*command, options);
  command->add_flag("--force", match.force, "replace existing files");
  command->add_flag("--json", match.json, "print JSON");
  return command;
}

int serve(const ServeCommand& options) {
  if (options.no_referee) {
    if (auto checked = checkAlone(options); !checked) return report(checked.error());
    return simulate(options.match.settings, options.wire, options.alone, options.match.json);
  }
  MatchCommand command = options.match;
  MatchSettings& settings = command.settings;
  if (settings.blue != kClient && settings.yellow != kClient) {
    return report(
        {ErrorCode::kUsage, "serve: no team is left for a client; play without one: fulbito match"});
  }
  if (settings.blue == kClient) settings.blue = clientOf(TeamId::kBlue, options.wire);
  if (settings.yellow == kClient) settings.yellow = clientOf(TeamId::kYellow, options.wire);
  return match(command);
}

}  // namespace fulbito::app
