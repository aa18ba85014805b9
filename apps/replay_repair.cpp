#include "apps/replay_repair.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/commands.hpp"
#include "apps/new_file.hpp"
#include "match/repair.hpp"

namespace fulbito::app {

CLI::App* addReplayRepair(CLI::App& replay, ReplayRepairCommand& options) {
  CLI::App* command =
      replay.add_subcommand("repair", "make a whole recording of what can still be read of one");
  command->footer(
      "Keeps what precedes the damage and every play that begins after it.\n"
      "Example:\n"
      "  fulbito replay repair broken.fbr mended.fbr");
  command->add_option("file", options.file, "recording (.fbr)")->required();
  command->add_option("out", options.out, "recording that is made")->required();
  command->add_flag("--force", options.force, "replace a file that exists");
  return command;
}

int replayRepair(const ReplayRepairCommand& options) {
  if (auto may = mayWrite(options.out, options.force); !may) return report(may.error());
  const auto found = salvage(options.file);
  if (!found) return report(found.error());
  if (found->whole) {
    fmt::print("{}: nothing is wrong with it; nothing was written\n", options.file);
    return kOk;
  }
  const auto repaired = repair(*found);
  if (!repaired) return report({repaired.error().code, options.file + ": " + repaired.error().message});
  if (auto written = writeFile(options.out, repaired->bytes); !written) return report(written.error());
  const double dt = 1.0 / found->header.control_rate;
  fmt::print("{}: {} plays, {:.3f} s kept\n", options.out, repaired->plays,
             static_cast<double>(repaired->ticks) * dt);
  fmt::print("lost: {} bytes, {} gaps, {:.3f} s of what is known{}\n", found->lost_bytes, repaired->gaps,
             static_cast<double>(repaired->lost_ticks) * dt, repaired->end_lost ? ", and the end" : "");
  return kOk;
}

}  // namespace fulbito::app
