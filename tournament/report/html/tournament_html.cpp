#include "engine/core/base/xml_text.hpp"
#include "replays/html/page_form.hpp"
#include "tournament/report/html/html_parts.hpp"
#include "tournament/report/report.hpp"
#include "tournament/report/sections.hpp"

namespace fulbito {

std::span<const EmbeddedFile> embeddedReport();

namespace {

constexpr std::size_t kMostCrossed = 48;

std::string tableSection(const Grid& grid, const std::string& classes, const std::string& table_classes,
                         const RecordingLinks& recordings) {
  if (grid.rows.empty()) return {};
  return htmlSection(classes, grid.title, htmlTable(grid, table_classes, recordings));
}

std::string sectionsOf(const TournamentState& state, const TournamentTable& table,
                       const RecordingLinks& recordings) {
  std::string html = htmlMatch(state) + htmlBracket(state, table);
  html += tableSection(unplayedGrid(state), "wide", "plain", recordings);
  for (const Grid& grid : standingGrids(state, table)) html += tableSection(grid, "wide", "", recordings);
  html += htmlRatings(state, table) + htmlCourse(state, table);
  html += tableSection(crossGrid(state, table, kMostCrossed), "wide", "cross", recordings);
  html += tableSection(startGrid(state, table), "wide", "", recordings);
  html += tableSection(faultGrid(state, table), "wide", "", recordings);
  return html + tableSection(notableGrid(state, table), "wide", "plain", recordings);
}

std::string notesOf(const ReportHead& head) {
  std::string html;
  for (const std::string& note : head.notes) html += "  <p>" + escapedXml(note) + "</p>\n";
  return html;
}

}  // namespace

std::string tournamentHtml(const TournamentState& state, const TournamentTable& table,
                           const RecordingLinks& recordings) {
  const ReportHead head = headOf(state, table);
  return filledForm(textOfFile(embeddedReport(), "page"),
                    {{"style-digest", allowedDigest(FULBITO_REPORT_STYLE_DIGEST)},
                     {"style", std::string(textOfFile(embeddedReport(), "style"))},
                     {"title", escapedXml(head.title)},
                     {"rules", escapedXml(head.rules)},
                     {"progress", escapedXml(head.progress)},
                     {"notes", notesOf(head)},
                     {"sections", sectionsOf(state, table, recordings)}});
}

}  // namespace fulbito
