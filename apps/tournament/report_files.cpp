#include "apps/tournament/report_files.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "apps/common/console.hpp"
#include "apps/common/outputs.hpp"
#include "apps/tournament/recordings.hpp"
#include "engine/core/system/output_file.hpp"

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

Result<void> writeReports(const TournamentState& state, const TournamentTable& table,
                          const ReportFiles& files, const std::string& recordings) {
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
  return writeFile(files.html, tournamentHtml(state, table, *pages));
}

}  // namespace fulbito::app
