#include "apps/replay/replay.hpp"

#include <CLI/CLI.hpp>

namespace fulbito::app {

CLI::App* addReplay(CLI::App& app, ReplayCommands& options) {
  CLI::App* command =
      app.add_subcommand("replay", "inspect, verify, compare, edit, export and send recordings");
  command->footer(
      "Examples:\n"
      "  fulbito match libero classic --record game.fbr   make a recording\n"
      "  fulbito replay info game.fbr                     teams, result, settings, size\n"
      "  fulbito replay events game.fbr\n"
      "  fulbito replay verify game.fbr                   simulate it again and compare, bit for bit\n"
      "  fulbito replay diff game.fbr other.fbr           the first difference\n"
      "  fulbito replay cut game.fbr goal.fbr --from 40 --to 50\n"
      "  fulbito replay export game.fbr --html game.html  an HTML page with a viewer\n"
      "  fulbito replay export game.fbr --png --at 83.2   pictures, films, tables\n"
      "  fulbito replay send game.fbr                     to clients of the league, as vision frames\n"
      "More: docs/recordings.md, docs/pictures.md, docs/league.md.");
  command->require_subcommand(1);
  options.command = command;
  addReplayInfo(*command, options.info);
  addReplayEvents(*command, options.events);
  addReplayVerify(*command, options.verify);
  addReplayDiff(*command, options.diff);
  addReplayCut(*command, options.cut);
  addReplayRepair(*command, options.repair);
  addReplayExport(*command, options.exporting);
  addReplaySend(*command, options.send);
  return command;
}

int replay(const ReplayCommands& options) {
  const auto named = [&](const char* part) { return options.command->got_subcommand(part); };
  if (named("info")) return replayInfo(options.info);
  if (named("events")) return replayEvents(options.events);
  if (named("export")) return replayExport(options.exporting);
  if (named("diff")) return replayDiff(options.diff);
  if (named("cut")) return replayCut(options.cut);
  if (named("repair")) return replayRepair(options.repair);
  if (named("send")) return replaySend(options.send);
  return replayVerify(options.verify);
}

}  // namespace fulbito::app
