#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "apps/view/view_window.hpp"
#include "fulbito/match.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace fulbito::app {

/// Options of a viewer window.
struct ViewOptions {
  double speed = 1.0;
  std::string theme = "dark";
  std::string size;  ///< WIDTHxHEIGHT; empty: as large as fits
  bool paused = false;
  bool full_screen = false;
  bool help = false;
  std::int64_t frames = 0;
  std::string screenshot;
};

/// Options of `fulbito view`.
struct ViewCommand {
  std::vector<std::string> files;
  double from = 0.0;  ///< [s] time at which the display begins
  bool json = false;
  ViewOptions window;
};

/// Adds `view`.
CLI::App* addView(CLI::App& app, ViewCommand& options);
/// Adds the window options. If `needed` is given, each of them requires that option.
/// @param speed  whether --speed is one of them
void addViewOptions(CLI::App& command, ViewOptions& options, CLI::Option* needed = nullptr,
                    bool speed = true);

/// Shows recordings and returns the exit code.
int view(const ViewCommand& options);

/// Opens the window. Errors: kUsage for invalid options; as `ViewWindow::create`.
Result<ViewWindow> openWindow(const ViewOptions& options);
/// Plays a match in the window until the user closes it. The match then ends at its present state. Errors: as
/// `ViewWindow::run`.
Result<void> playInWindow(Match& match, ViewWindow& window, const ViewOptions& options);

}  // namespace fulbito::app
