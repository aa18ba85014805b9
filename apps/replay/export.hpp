#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/replay/export_html.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// Options of `fulbito replay export`. An empty file name of a product means: named after the recording.
struct ReplayExportCommand {
  const CLI::App* command = nullptr;  ///< tells which flags were given
  std::string file;
  std::optional<std::string> png, contact_sheet, trails, gif, mp4, webm, svg, csv, jsonl;
  std::vector<std::string> heatmap;  ///< body, and optionally the output file
  HtmlExport html;
  std::vector<double> at;  ///< [s]
  std::string around;      ///< name of the events
  bool highlights = false;
  std::optional<double> from, to, fps, speed;
  std::string size;  ///< "W" or "WxH"; empty: the product's own
  std::string theme = "dark";
  double trail_seconds = 1.0;
  bool no_banner = false, no_drawings = false;
  int jobs = 0;  ///< 0: all cores
  int quality = 22;
  bool force = false;
};

/// Adds `export` to `replay`.
CLI::App* addReplayExport(CLI::App& replay, ReplayExportCommand& options);

/// Runs the command and returns its exit code.
int replayExport(const ReplayExportCommand& options);

}  // namespace fulbito::app
