#include "apps/replay_export.hpp"

#include <CLI/CLI.hpp>

#include "apps/commands.hpp"

namespace fulbito::app {

CLI::App* addReplayExport(CLI::App& replay, ReplayExportCommand& options) {
  CLI::App* command = replay.add_subcommand("export", "make pages of a recording");
  command->footer(
      "Examples:\n"
      "  fulbito replay export game.fbr --html game.html\n"
      "  fulbito replay export game.fbr --html both.html --ghost other.fbr   two matches over each other");
  command->add_option("file", options.file, "recording")->required();
  addHtmlOptions(*command, options.html);
  command->add_flag("--force", options.force, "replace files that exist");
  return command;
}

int replayExport(const ReplayExportCommand& options) {
  if (options.html.html.empty()) {
    return report({ErrorCode::kUsage, "replay export: say what to make, e.g. --html game.html"});
  }
  return replayExportHtml(options.file, options.html, options.force);
}

}  // namespace fulbito::app
