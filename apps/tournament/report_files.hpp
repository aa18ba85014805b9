#pragma once

#include <string>

#include "tournament/report/report.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// What a command writes about a tournament.
struct ReportFiles {
  bool json = false;
  std::string csv;  ///< @{ files; empty: none, "-" for stdout
  std::string markdown;
  std::string junit;
  std::string html;
  /// @}
  bool annotations = false;  ///< GitHub annotations on stdout
};

/// Adds --json, --csv, --markdown, --junit, --html, --annotations and --force. The files replace those of
/// their kind, as they are the newest state.
void addReportFiles(CLI::App& command, ReportFiles& files);

/// Checks that at most one report goes to stdout. Errors: kUsage.
Result<void> checkReportFiles(const ReportFiles& files);

/// Writes the files and prints the report for people, unless one on stdout replaces it. With a page of
/// matches that are not recorded, says on stderr the command that records them.
/// @param folder  of the results, with the recordings; may be empty
Result<void> writeReports(const TournamentState& state, const ReportFiles& files, const std::string& folder);

}  // namespace fulbito::app
