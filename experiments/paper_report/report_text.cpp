#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "fulbito/report.hpp"

namespace fulbito {
namespace {

std::string numberText(double value, int decimals) {
  if (!std::isfinite(value)) return "-";
  const std::string text = fmt::format("{:.{}f}", value, decimals);
  // Avoids "-0.00" for negative values that round to zero.
  return text.find_first_not_of("-0.") == std::string::npos && text[0] == '-' ? text.substr(1) : text;
}

std::string withUnit(const std::string& text, const std::string& unit) {
  return unit.empty() || text == "-" ? text : text + " " + unit;
}

std::string bandText(const PaperFigure& figure) {
  const bool low = std::isfinite(figure.low), high = std::isfinite(figure.high);
  const auto text = [&](double value) { return numberText(value, figure.decimals); };
  if (low && high) return withUnit(text(figure.low) + " to " + text(figure.high), figure.unit);
  if (low) return "at least " + withUnit(text(figure.low), figure.unit);
  if (high) return "at most " + withUnit(text(figure.high), figure.unit);
  return "-";
}

std::string judgement(const PaperFigure& figure) {
  if (bandText(figure) == "-") return "-";
  return figure.inside() ? "yes" : "no";
}

std::string cellText(const ReportCell& cell, const ReportColumn& column) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return numberText(std::get<double>(cell), column.decimals);
}

void appendFigures(std::string& out, const std::vector<PaperFigure>& figures) {
  if (figures.empty()) return;
  out += "\n| where | what | paper | ours | band | inside | why |\n|---|---|---|---|---|---|---|\n";
  for (const PaperFigure& f : figures) {
    const double paper = f.paper.value_or(std::numeric_limits<double>::quiet_NaN());
    out += fmt::format("| {} | {} | {} | {} | {} | {} | {} |\n", f.where, f.what,
                       withUnit(numberText(paper, f.decimals), f.unit),
                       withUnit(numberText(f.ours, f.decimals), f.unit), bandText(f), judgement(f), f.reason);
  }
}

void appendTable(std::string& out, const ReportTable& table) {
  out += fmt::format("\n### {}\n\n|", table.title);
  for (const ReportColumn& column : table.columns) out += fmt::format(" {} |", column.name);
  out += "\n|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) out += "---|";
  out += "\n";
  const std::size_t shown = std::min(table.shown, table.rows.size());
  for (std::size_t r = 0; r < shown; ++r) {
    out += "|";
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      out += fmt::format(" {} |", cellText(table.rows[r][c], table.columns[c]));
    }
    out += "\n";
  }
  if (shown < table.rows.size()) {
    out += fmt::format("\n{} of {} rows; {}.csv has all.\n", shown, table.rows.size(), table.name);
  }
}

/// Quotes text that a CSV reader would split or misread.
std::string csvText(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string csvCell(const ReportCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return csvText(*text);
  const double value = std::get<double>(cell);
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

}  // namespace

std::string experimentText(const ExperimentReport& report) {
  std::string out = fmt::format("## {}\n", report.title);
  appendFigures(out, report.figures);
  for (const ReportTable& table : report.tables) appendTable(out, table);
  for (const std::string& note : report.notes) out += fmt::format("\n{}\n", note);
  return out;
}

std::string tableCsv(const ReportTable& table) {
  std::string out;
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    out += (i == 0 ? "" : ",") + csvText(table.columns[i].name);
  }
  out += "\n";
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) out += (i == 0 ? "" : ",") + csvCell(row[i]);
    out += "\n";
  }
  return out;
}

}  // namespace fulbito
