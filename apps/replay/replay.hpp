#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/replay/export_html.hpp"

namespace CLI {
class App;
}

/// `fulbito replay`: one part per file of the same name.
namespace fulbito::app {

/// What `fulbito replay info` was asked.
struct ReplayInfoCommand {
  std::string file;
  bool json = false;
};

/// Adds `info` to `replay`.
CLI::App* addReplayInfo(CLI::App& replay, ReplayInfoCommand& options);

/// Runs it and returns the exit code.
int replayInfo(const ReplayInfoCommand& options);

/// What `fulbito replay events` was asked.
struct ReplayEventsCommand {
  std::string file;
  bool json = false;
};

/// Adds `events` to `replay`.
CLI::App* addReplayEvents(CLI::App& replay, ReplayEventsCommand& options);

/// Runs it and returns the exit code.
int replayEvents(const ReplayEventsCommand& options);

/// What `fulbito replay verify` was asked.
struct ReplayVerifyCommand {
  std::vector<std::string> files;  ///< or folders
  int jobs = 0;
  bool json = false;
};

/// Adds `verify` to `replay`.
CLI::App* addReplayVerify(CLI::App& replay, ReplayVerifyCommand& options);

/// Runs it and returns the exit code.
int replayVerify(const ReplayVerifyCommand& options);

/// What `fulbito replay diff` was asked.
struct ReplayDiffCommand {
  std::string a;
  std::string b;
  bool json = false;
};

/// Adds `diff` to `replay`.
CLI::App* addReplayDiff(CLI::App& replay, ReplayDiffCommand& options);

/// Runs it and returns the exit code.
int replayDiff(const ReplayDiffCommand& options);

/// What `fulbito replay cut` was asked.
struct ReplayCutCommand {
  std::string file;
  std::string out;
  std::optional<double> from;  ///< [s] of the recording
  std::optional<double> to;    ///< [s]
  std::string plays;           ///< A-B, counted from 1
  bool json = false;
};

/// Adds `cut` to `replay`.
CLI::App* addReplayCut(CLI::App& replay, ReplayCutCommand& options);

/// Runs it and returns the exit code.
int replayCut(const ReplayCutCommand& options);

/// What `fulbito replay repair` was asked.
struct ReplayRepairCommand {
  std::string file;
  std::string out;
  bool json = false;
};

/// Adds `repair` to `replay`.
CLI::App* addReplayRepair(CLI::App& replay, ReplayRepairCommand& options);

/// Runs it and returns the exit code.
int replayRepair(const ReplayRepairCommand& options);

/// What `fulbito replay export` was asked. Of a product that was asked for without a file the name is empty:
/// it is named after the recording.
struct ReplayExportCommand {
  const CLI::App* command = nullptr;  ///< knows which flags were given
  std::string file;
  std::optional<std::string> png, contact_sheet, trails, gif, mp4, webm, svg, csv, jsonl;
  std::vector<std::string> heatmap;  ///< whose, and where it is written
  HtmlExport html;
  std::vector<double> at;  ///< [s]
  std::string around;      ///< name of events
  bool highlights = false;
  std::optional<double> from, to, fps, speed;
  std::string size;  ///< "W" or "WxH"; empty: the product's own
  std::string theme = "dark";
  double trail_seconds = 1.0;
  bool no_banner = false, no_drawings = false;
  int jobs = 0;  ///< 0: all cores
  int quality = 22;
};

/// Adds `export` to `replay`.
CLI::App* addReplayExport(CLI::App& replay, ReplayExportCommand& options);

/// Runs it and returns the exit code.
int replayExport(const ReplayExportCommand& options);

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
