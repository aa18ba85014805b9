#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/base/text_controls.hpp"
#include "fulbito/detail/build_info.hpp"
#include "match/drills/worth.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

/// Rates in percent, goals per match unchanged.
std::string shown(bool matches, double value) {
  return matches ? fmt::format("{:.2f}", value) : fmt::format("{:.1f} %", 100 * value);
}

std::string shownSigned(bool matches, double value) {
  return matches ? fmt::format("{:+.2f}", value) : fmt::format("{:+.1f}", 100 * value);
}

std::string worthText(bool matches, const Interval& worth) {
  std::string text = shownSigned(matches, worth.value);
  if (!std::isnan(worth.low)) {
    text += fmt::format(" ({} ... {})", shownSigned(matches, worth.low), shownSigned(matches, worth.high));
  }
  return text;
}

/// Whether the whole interval lies on one side of zero.
const char* verdictOf(const DrillWorth& worth) {
  if (worth.worth.low > 0.0) return "helps";
  return worth.worth.high < 0.0 ? "hurts" : "not shown";
}

bool changesNothing(const SkillWorth& skill) {
  return std::all_of(skill.drills.begin(), skill.drills.end(),
                     [](const DrillWorth& worth) { return worth.changed == 0; });
}

std::string rowsOf(const WorthReport& report, const SkillWorth& skill) {
  std::string rows;
  for (std::size_t i = 0; i < skill.drills.size(); ++i) {
    const DrillWorth& worth = skill.drills[i];
    if (worth.changed == 0) continue;
    const DrillReport& drill = report.whole[i];
    const bool matches = drill.ofMatches();
    rows += fmt::format("| {} | {} {} | {} of {} | {} | {} | {} | {} |\n",
                        rows.empty() ? skill.left_out.skill : "", drill.drill.number, drill.drill.name,
                        worth.changed, worth.count, shown(matches, worth.with), shown(matches, worth.without),
                        worthText(matches, worth.worth), verdictOf(worth));
  }
  return rows;
}

Json numberOf(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json drillJson(const DrillReport& report, const DrillWorth& worth) {
  return {{"number", report.drill.number},
          {"name", report.drill.name},
          {"unit", report.ofMatches() ? "goals" : "share"},
          {"count", worth.count},
          {"changed", worth.changed},
          {"with", worth.with},
          {"without", worth.without},
          {"worth", worth.worth.value},
          {"low", numberOf(worth.worth.low)},
          {"high", numberOf(worth.worth.high)}};
}

}  // namespace

std::string worthTable(const WorthReport& report, const DrillOptions& options) {
  std::string text = fmt::format("## What skills of {} are worth (seed {}, robot {}, physics {})\n\n",
                                 options.team.text, options.seed, options.robot, options.physics);
  std::string rows, unchanged;
  for (const SkillWorth& skill : report.skills) {
    rows += rowsOf(report, skill);
    if (changesNothing(skill)) unchanged += (unchanged.empty() ? "" : ", ") + skill.left_out.skill;
  }
  if (!rows.empty()) {
    text +=
        "| skill | drill | trials changed | with | without | worth (95 %) | verdict |\n"
        "|---|---|---|---|---|---|---|\n" +
        rows + "\n";
  }
  if (!unchanged.empty()) text += fmt::format("No trial changes without: {}.\n", unchanged);
  return text;
}

std::string worthJson(const WorthReport& report, const DrillOptions& options) {
  Json json{{"schema_version", 1},    {"team", options.team.text},  {"seed", options.seed},
            {"robot", options.robot}, {"physics", options.physics}, {"build", buildInfo().version},
            {"skills", Json::array()}};
  for (const SkillWorth& skill : report.skills) {
    Json drills = Json::array();
    for (std::size_t i = 0; i < skill.drills.size(); ++i) {
      drills.push_back(drillJson(report.whole[i], skill.drills[i]));
    }
    json["skills"].push_back(
        {{"skill", skill.left_out.skill}, {"team", skill.left_out.team.text}, {"drills", std::move(drills)}});
  }
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace fulbito
