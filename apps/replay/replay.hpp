#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/replay/export_html.hpp"
#include "bridge/wire/wire_settings.hpp"

namespace CLI {
class App;
}

/// `fulbito replay`. Each subcommand is in the file of its name.
namespace fulbito::app {

/// Options of `fulbito replay info`.
struct ReplayInfoCommand {
  std::string file;
  bool json = false;
};

/// Adds `info` to `replay`.
CLI::App* addReplayInfo(CLI::App& replay, ReplayInfoCommand& options);

/// Runs the command and returns its exit code.
int replayInfo(const ReplayInfoCommand& options);

/// Options of `fulbito replay events`.
struct ReplayEventsCommand {
  std::string file;
  bool json = false;
};

/// Adds `events` to `replay`.
CLI::App* addReplayEvents(CLI::App& replay, ReplayEventsCommand& options);

/// Runs the command and returns its exit code.
int replayEvents(const ReplayEventsCommand& options);

/// Options of `fulbito replay verify`.
struct ReplayVerifyCommand {
  std::vector<std::string> files;  ///< files or folders
  int jobs = 0;
  bool json = false;
};

/// Adds `verify` to `replay`.
CLI::App* addReplayVerify(CLI::App& replay, ReplayVerifyCommand& options);

/// Runs the command and returns its exit code.
int replayVerify(const ReplayVerifyCommand& options);

/// Options of `fulbito replay diff`.
struct ReplayDiffCommand {
  std::string a;
  std::string b;
  bool json = false;
};

/// Adds `diff` to `replay`.
CLI::App* addReplayDiff(CLI::App& replay, ReplayDiffCommand& options);

/// Runs the command and returns its exit code.
int replayDiff(const ReplayDiffCommand& options);

/// Options of `fulbito replay cut`.
struct ReplayCutCommand {
  std::string file;
  std::string out;
  std::optional<double> from;  ///< [s] time in the recording; empty: its begin
  std::optional<double> to;    ///< [s] time in the recording; empty: its end
  std::string plays;           ///< range of plays A-B, counted from 1
  bool json = false;
};

/// Adds `cut` to `replay`.
CLI::App* addReplayCut(CLI::App& replay, ReplayCutCommand& options);

/// Runs the command and returns its exit code.
int replayCut(const ReplayCutCommand& options);

/// Options of `fulbito replay repair`.
struct ReplayRepairCommand {
  std::string file;
  std::string out;
  bool json = false;
};

/// Adds `repair` to `replay`.
CLI::App* addReplayRepair(CLI::App& replay, ReplayRepairCommand& options);

/// Runs the command and returns its exit code.
int replayRepair(const ReplayRepairCommand& options);

/// Options of `fulbito replay export`. A product has an empty name if it was requested without a file; it is
/// then named after the recording.
struct ReplayExportCommand {
  const CLI::App* command = nullptr;  ///< tells which flags were given
  std::string file;
  std::optional<std::string> png, contact_sheet, trails, gif, mp4, webm, svg, csv, jsonl;
  std::vector<std::string> heatmap;  ///< whose heat map, and optionally its file
  HtmlExport html;
  std::vector<double> at;  ///< times of pictures [s]
  std::string around;      ///< name of events; empty: none
  bool highlights = false;
  std::optional<double> from, to, fps, speed;
  std::string size;  ///< "W" or "WxH"; empty: the default of the product
  std::string theme = "dark";
  double trail_seconds = 1.0;
  bool no_banner = false, no_drawings = false;
  int jobs = 0;  ///< 0: all cores
  int quality = 22;
};

/// Adds `export` to `replay`.
CLI::App* addReplayExport(CLI::App& replay, ReplayExportCommand& options);

/// Runs the command and returns its exit code.
int replayExport(const ReplayExportCommand& options);

/// Options of `fulbito replay send`.
struct ReplaySendCommand {
  std::string file;
  double speed = 1.0;              ///< over real time
  std::optional<double> from, to;  ///< [s] time in the recording; empty: its begin or end
  bool loop = false;
  int port_base = wire::kDefaultPortBase;
  std::string interface;  ///< empty: the system's choice
  bool json = false;
};

/// Adds `send` to `replay`.
CLI::App* addReplaySend(CLI::App& replay, ReplaySendCommand& options);

/// Runs the command and returns its exit code.
int replaySend(const ReplaySendCommand& options);

/// Options of `fulbito replay` and its subcommands.
struct ReplayCommands {
  CLI::App* command = nullptr;  ///< tells which subcommand was given
  ReplayInfoCommand info;
  ReplayEventsCommand events;
  ReplayVerifyCommand verify;
  ReplayDiffCommand diff;
  ReplayCutCommand cut;
  ReplayRepairCommand repair;
  ReplayExportCommand exporting;
  ReplaySendCommand send;
};

/// Adds `replay` with its subcommands.
CLI::App* addReplay(CLI::App& app, ReplayCommands& options);

/// Runs the given subcommand and returns its exit code.
int replay(const ReplayCommands& options);

}  // namespace fulbito::app
