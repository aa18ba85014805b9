#include "apps/replay/replay.hpp"

#include <CLI/CLI.hpp>

namespace fulbito::app {

CLI::App* addReplay(CLI::App& app, ReplayCommands& options) {
  CLI::App* command = app.add_subcommand("replay", "look into recordings, prove, compare and cut them");
  command->footer(
      "Examples:\n"
      "  fulbito match libero classic --record game.fbr   makes one\n"
      "  fulbito replay info game.fbr                     what was played, and where the bytes go\n"
      "  fulbito replay events game.fbr\n"
      "  fulbito replay verify game.fbr                   plays it again: is it the same, bit for bit?\n"
      "  fulbito replay diff game.fbr other.fbr           where two part\n"
      "  fulbito replay cut game.fbr goal.fbr --from 40 --to 50\n"
      "  fulbito replay export game.fbr --html game.html  a page to look at it\n"
      "  fulbito replay export game.fbr --png --at 83.2   pictures, films, tables\n"
      "More: docs/recordings.md, docs/pictures.md.");
  command->require_subcommand(1);
  options.command = command;
  addReplayInfo(*command, options.info);
  addReplayEvents(*command, options.events);
  addReplayVerify(*command, options.verify);
  addReplayDiff(*command, options.diff);
  addReplayCut(*command, options.cut);
  addReplayRepair(*command, options.repair);
  addReplayExport(*command, options.exporting);
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
  return replayVerify(options.verify);
}

}  // namespace fulbito::app
