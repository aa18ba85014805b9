#pragma once

#include "apps/replay/cut.hpp"
#include "apps/replay/diff.hpp"
#include "apps/replay/events.hpp"
#include "apps/replay/export.hpp"
#include "apps/replay/info.hpp"
#include "apps/replay/repair.hpp"
#include "apps/replay/verify.hpp"

namespace fulbito::app {

/// Options of `fulbito replay`, by subcommand.
struct ReplayCommands {
  CLI::App* command = nullptr;  ///< tells which subcommand was given
  ReplayInfoCommand info;
  ReplayEventsCommand events;
  ReplayVerifyCommand verify;
  ReplayDiffCommand diff;
  ReplayCutCommand cut;
  ReplayRepairCommand repair;
  ReplayExportCommand exporting;
};

/// Adds `replay` with its subcommands.
CLI::App* addReplay(CLI::App& app, ReplayCommands& options);

/// Runs the given subcommand and returns its exit code.
int replay(const ReplayCommands& options);

}  // namespace fulbito::app
