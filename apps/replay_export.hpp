#pragma once

#include <string>

#include "apps/replay_export_html.hpp"

namespace fulbito::app {

/// What `fulbito replay export` was asked.
struct ReplayExportCommand {
  std::string file;
  HtmlExport html;
  bool force = false;
};

/// Adds `export` to `replay`.
CLI::App* addReplayExport(CLI::App& replay, ReplayExportCommand& options);

/// Runs it and returns the exit code.
int replayExport(const ReplayExportCommand& options);

}  // namespace fulbito::app
