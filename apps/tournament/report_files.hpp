#pragma once

#include <string>

#include "tournament/report/report.hpp"

namespace CLI {
class App;
}

namespace fulbito::app {

/// The reports that a command writes about a tournament.
struct ReportFiles {
  bool json = false;
  std::string csv;  ///< @{ report files; empty: none, "-": stdout
  std::string markdown;
  std::string junit;
  std::string html;
  /// @}
  bool annotations = false;  ///< GitHub annotations on stdout
};

/// Adds --json, --csv, --markdown, --junit, --html, --annotations and --force. The files replace existing
/// ones of their kind, because they are newer versions.
void addReportFiles(CLI::App& command, ReportFiles& files);

/// Checks that at most one report goes to stdout. Errors: kUsage.
Result<void> checkReportFiles(const ReportFiles& files);

/// Writes the files, and prints the report for people unless another report goes to stdout. If an HTML page
/// has matches without recordings, prints the command that records them on stderr.
/// @param folder  folder of the results and recordings; may be empty
Result<void> writeReports(const TournamentState& state, const ReportFiles& files, const std::string& folder);

}  // namespace fulbito::app
