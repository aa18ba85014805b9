#pragma once

#include "apps/replay_cut.hpp"
#include "apps/replay_diff.hpp"
#include "apps/replay_events.hpp"
#include "apps/replay_export.hpp"
#include "apps/replay_info.hpp"
#include "apps/replay_repair.hpp"
#include "apps/replay_verify.hpp"

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
