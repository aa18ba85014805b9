#pragma once

#include <optional>
#include <string>
#include <vector>

#include "apps/replay/export_html.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

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
  bool force = false;
};

/// Adds `export` to `replay`.
CLI::App* addReplayExport(CLI::App& replay, ReplayExportCommand& options);

/// Runs it and returns the exit code.
int replayExport(const ReplayExportCommand& options);

}  // namespace fulbito::app
