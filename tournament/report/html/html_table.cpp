#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/base/xml_text.hpp"
#include "tournament/report/html/html_parts.hpp"

namespace fulbito {
namespace {

/// The CSS class for the colour of a share: s0 (lost all) ... s10 (won all).
std::string shadeOf(double share) {
  return fmt::format("s{}", static_cast<int>(std::lround(10.0 * std::clamp(share, 0.0, 1.0))));
}

std::string contentOf(const GridColumn& column, const GridCell& cell, const RecordingLinks& recordings) {
  std::string text = escapedXml(cell.text);
  if (column.flexible) text = "<bdi>" + text + "</bdi>";
  const auto recording = recordings.find(cell.match);
  if (cell.match.empty() || recording == recordings.end()) return text;
  return fmt::format("<a href=\"{}\" title=\"watch\">{} ▸</a>", relativeAddress(recording->second), text);
}

std::string classesOf(const GridColumn& column, const GridCell& cell) {
  std::string classes = column.number ? "n" : "";
  if (cell.share) classes += (classes.empty() ? "" : " ") + shadeOf(*cell.share);
  return classes.empty() ? "" : " class=\"" + classes + '"';
}

std::string rowOf(const Grid& grid, const std::vector<GridCell>& row, const RecordingLinks& recordings) {
  std::string html = "<tr>";
  bool named = false;
  for (std::size_t c = 0; c < row.size(); ++c) {
    const GridColumn& column = grid.columns[c];
    // The first flexible cell of a row is the row's heading.
    const bool heading = column.flexible && !named;
    named = named || heading;
    const std::string hint = row[c].hint.empty() ? "" : " title=\"" + escapedXml(row[c].hint) + '"';
    html +=
        fmt::format("<{0}{1}{2}>{3}</{4}>", heading ? "th scope=\"row\"" : "td", classesOf(column, row[c]),
                    hint, contentOf(column, row[c], recordings), heading ? "th" : "td");
  }
  return html + "</tr>\n";
}

bool isUnreserved(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("-._~/").find(c) != std::string_view::npos;
}

}  // namespace

std::string relativeAddress(const std::string& name) {
  std::string address = "./";
  for (const char c : name) {
    address += isUnreserved(c) ? std::string(1, c)
                               : fmt::format("%{:02X}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return address;
}

std::string htmlSection(const std::string& classes, const std::string& title, const std::string& content) {
  return fmt::format("<section{}>\n<h2>{}</h2>\n{}</section>\n",
                     classes.empty() ? "" : " class=\"" + classes + '"', escapedXml(title), content);
}

std::string htmlScroll(const std::string& label, const std::string& content) {
  return fmt::format("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"{}\">\n{}</div>\n",
                     escapedXml(label), content);
}

std::string htmlTable(const Grid& grid, const std::string& classes, const RecordingLinks& recordings) {
  std::string html = fmt::format("<table class=\"{}\"><thead><tr>", classes);
  for (const GridColumn& column : grid.columns) {
    html += fmt::format("<th scope=\"col\"{}>{}</th>", column.number ? " class=\"n\"" : "",
                        escapedXml(column.head));
  }
  html += "</tr></thead>\n<tbody>\n";
  const std::size_t shown = std::min(kMostHtmlRows, grid.rows.size());
  for (std::size_t i = 0; i < shown; ++i) html += rowOf(grid, grid.rows[i], recordings);
  html = htmlScroll(grid.title, html + "</tbody></table>\n");
  if (shown < grid.rows.size()) {
    html += fmt::format("<p class=\"note\">{} more rows do not fit here.</p>\n", grid.rows.size() - shown);
  }
  if (!grid.note.empty()) html += "<p class=\"note\">" + escapedXml(grid.note) + "</p>\n";
  return html;
}

}  // namespace fulbito
