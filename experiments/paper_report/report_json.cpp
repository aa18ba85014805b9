#include <cmath>

#include <nlohmann/json.hpp>

#include "engine/core/base/text_controls.hpp"
#include "fulbito/detail/build_info.hpp"
#include "fulbito/report.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;

/// JSON has no NaN and no infinity: null means "no value" or "no limit".
Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json figureJson(const PaperFigure& figure) {
  return {{"id", figure.id},
          {"where", figure.where},
          {"what", figure.what},
          {"unit", figure.unit},
          {"paper", figure.paper ? numberOrNull(*figure.paper) : Json(nullptr)},
          {"ours", numberOrNull(figure.ours)},
          {"low", numberOrNull(figure.low)},
          {"high", numberOrNull(figure.high)},
          {"inside", figure.inside()},
          {"reason", figure.reason}};
}

Json cellJson(const ReportCell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  return numberOrNull(std::get<double>(cell));
}

Json tableJson(const ReportTable& table) {
  Json columns = Json::array(), rows = Json::array();
  for (const ReportColumn& column : table.columns) columns.push_back(column.name);
  for (const auto& row : table.rows) {
    Json cells = Json::array();
    for (const ReportCell& cell : row) cells.push_back(cellJson(cell));
    rows.push_back(std::move(cells));
  }
  return {{"name", table.name}, {"title", table.title}, {"columns", columns}, {"rows", rows}};
}

Json settingsJson(const ExperimentRequest& request) {
  Json settings = Json::object();
  for (const Setting& setting : request.settings) settings[setting.name] = setting.value;
  return settings;
}

}  // namespace

std::string experimentJson(const ExperimentReport& report, const ExperimentRequest& request) {
  Json figures = Json::array(), tables = Json::array();
  for (const PaperFigure& figure : report.figures) figures.push_back(figureJson(figure));
  for (const ReportTable& table : report.tables) tables.push_back(tableJson(table));
  const Json json{{"schema_version", kSchemaVersion},
                  {"experiment", report.name},
                  {"title", report.title},
                  {"seed", request.seed},
                  {"settings", settingsJson(request)},
                  {"version", buildInfo().version},
                  {"figures", figures},
                  {"tables", tables},
                  {"notes", report.notes}};
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace fulbito
