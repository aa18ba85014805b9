#include "apps/tournament/report_files.hpp"

#include <algorithm>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/console.hpp"
#include "apps/common/outputs.hpp"
#include "apps/tournament/recordings.hpp"
#include "engine/core/system/output_file.hpp"
#include "tournament/folder/results_folder.hpp"

namespace fulbito::app {
namespace {

constexpr const char* kStdout = "-";

Result<void> writeText(const std::string& file, const std::string& text) {
  if (file.empty()) return {};
  if (file != kStdout) return writeFile(file, text);
  writeOut(text);
  return {};
}

bool printsOn(const ReportFiles& files) {
  return files.annotations || files.csv == kStdout || files.markdown == kStdout || files.junit == kStdout;
}

/// The text as one word of a shell, quoted if necessary.
std::string shellWord(const std::string& text) {
  const bool plain = std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("/._-+,:=@%").find(c) != std::string_view::npos;
  });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

}  // namespace

void addReportFiles(CLI::App& command, ReportFiles& files) {
  const auto file = [&command](const char* flag, std::string& name, const char* what, OutputTraits traits) {
    traits.existing = Existing::kReplaced;
    markOutput(command.add_option(flag, name, what)->type_name("FILE")->group("Reports"), traits);
  };
  command.add_flag("--json", files.json, "print JSON instead of text")->group("Reports");
  file("--csv", files.csv, "a line per match; - for stdout", {OutputKind::kCsv, Dash::kStdout});
  file("--markdown", files.markdown, "summary for a build server's page; - for stdout",
       {OutputKind::kMarkdown, Dash::kStdout});
  file("--junit", files.junit, "JUnit XML, a test case per match; - for stdout",
       {OutputKind::kJunit, Dash::kStdout});
  file("--html", files.html, "a page for browsers, with pages of recorded matches", {OutputKind::kPage});
  command.add_flag("--annotations", files.annotations, "print GitHub annotations, at most 10")
      ->group("Reports");
  addForce(command, "reports replace existing files of other kinds")->group("Reports");
}

Result<void> checkReportFiles(const ReportFiles& files) {
  int printed = files.json + files.annotations;
  for (const std::string& name : {files.csv, files.markdown, files.junit}) printed += name == kStdout ? 1 : 0;
  if (printed <= 1) return {};
  return fail(ErrorCode::kUsage, "only one report can be printed on stdout");
}

Result<void> writeReports(const TournamentState& state, const ReportFiles& files, const std::string& folder) {
  TournamentTable table = tableOf(state);
  const std::string recordings = recordingsOf(folder);
  table.recorded = areRecorded(table.notable, recordings);
  if (files.json) writeOut(tournamentJson(state, table));
  if (files.annotations) writeOut(tournamentAnnotations(state, table));
  if (!files.json && !printsOn(files)) printOut(tournamentText(state, table));
  const auto write = [](const std::string& file, auto make) {
    return file.empty() ? Result<void>() : writeText(file, make());
  };
  if (auto done = write(files.csv, [&] { return tournamentCsv(state); }); !done) return done;
  if (auto done = write(files.markdown, [&] { return tournamentMarkdown(state, table); }); !done) return done;
  if (auto done = write(files.junit, [&] { return tournamentJunit(state, table); }); !done) return done;
  if (files.html.empty()) return {};
  const auto pages = writePages(table.notable, recordings, files.html);
  if (!pages) return tl::unexpected<Error>(pages.error());
  if (!table.recorded && !folder.empty()) {
    note("to watch the matches to look at: fulbito tournament report {} --recordings upsets --html {}\n",
         shellWord(folder), shellWord(files.html));
  }
  return writeFile(files.html, tournamentHtml(state, table, *pages));
}

}  // namespace fulbito::app
