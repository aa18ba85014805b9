#pragma once

#include "apps/replay/cut.hpp"
#include "apps/replay/diff.hpp"
#include "apps/replay/events.hpp"
#include "apps/replay/export.hpp"
#include "apps/replay/info.hpp"
#include "apps/replay/repair.hpp"
#include "apps/replay/verify.hpp"

namespace fulbito::app {

/// What `fulbito replay` was asked: each part keeps its own.
struct ReplayCommands {
  CLI::App* command = nullptr;  ///< knows which part was named
  ReplayInfoCommand info;
  ReplayEventsCommand events;
  ReplayVerifyCommand verify;
  ReplayDiffCommand diff;
  ReplayCutCommand cut;
  ReplayRepairCommand repair;
  ReplayExportCommand exporting;
};

/// Adds `replay` with its parts.
CLI::App* addReplay(CLI::App& app, ReplayCommands& options);

/// Runs the part that was named and returns its exit code.
int replay(const ReplayCommands& options);

}  // namespace fulbito::app
