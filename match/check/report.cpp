#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/base/text_controls.hpp"
#include "fulbito/detail/build_info.hpp"
#include "match/check/team_check.hpp"
#include "match/report/match_json.hpp"

namespace fulbito {

std::string teamCheckTable(const TeamReport& report) {
  std::string text =
      fmt::format("Check of {} (seed {}{})\n", report.team, report.seed, report.quick ? ", quick" : "");
  for (const Setting& entry : report.origin) text += fmt::format("  {}: {}\n", entry.name, entry.value);
  text += '\n';
  for (const TeamCheck& check : report.checks) {
    text += fmt::format("{:<12} {:<8} {}\n", check.name, nameOf(check.verdict), check.finding);
  }
  return text + fmt::format("\nverdict: {}\n", nameOf(report.verdict()));
}

std::string teamCheckJson(const TeamReport& report) {
  Json origin = Json::object(), checks = Json::array();
  for (const Setting& entry : report.origin) origin[entry.name] = entry.value;
  for (const TeamCheck& check : report.checks) {
    Json figures = Json::object();
    for (const auto& [name, value] : check.figures) figures[name] = value;
    checks.push_back({{"name", check.name},
                      {"verdict", nameOf(check.verdict)},
                      {"finding", check.finding},
                      {"figures", std::move(figures)}});
  }
  const Json json{{"schema_version", 1},
                  {"build", buildJson()},
                  {"team", report.team},
                  {"origin", std::move(origin)},
                  {"seed", report.seed},
                  {"quick", report.quick},
                  {"verdict", nameOf(report.verdict())},
                  {"checks", std::move(checks)}};
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + '\n';
}

}  // namespace fulbito
