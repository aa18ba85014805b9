#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/base/text_controls.hpp"
#include "fulbito/detail/build_info.hpp"
#include "match/drills/drill.hpp"

namespace fulbito {
namespace {

constexpr const char* kMeasures[] = {"success",    "time",       "excess",  "error",       "on target",
                                     "own goals",  "conceded",   "illegal", "early goals", "area fouls",
                                     "own stalls", "switches/s", "flaps",   "won",         "goals ahead",
                                     "side bias",  "kept"};
constexpr const char* kStatistics[] = {"rate", "count", "mean", "median", "p95"};

const char* nameOf(DrillMeasure measure) { return kMeasures[static_cast<std::size_t>(measure)]; }
const char* nameOf(DrillStatistic statistic) { return kStatistics[static_cast<std::size_t>(statistic)]; }

/// Lengths in cm, rates in percent, other values unchanged.
std::string shown(const DrillBar& bar, double value) {
  if (!std::isfinite(value)) return value > 0.0 ? "never" : "-";
  if (bar.statistic == DrillStatistic::kRate) return fmt::format("{:.1f} %", 100.0 * value);
  if (bar.statistic == DrillStatistic::kCount) return fmt::format("{:.0f}", value);
  if (bar.of_least) return fmt::format("{:.2f} x least", value);
  switch (bar.value) {
    case DrillMeasure::kError:
      return fmt::format("{:.2f} cm", 100.0 * value);
    case DrillMeasure::kTime:
    case DrillMeasure::kExcess:
      return fmt::format("{:.2f} s", value);
    default:
      return fmt::format("{:.2f}", value);
  }
}

std::string measured(const DrillVerdict& verdict) {
  const DrillBar& bar = verdict.bar;
  if (verdict.count == 0) return "no trials";
  const Interval& v = verdict.value;
  if (v.low == v.high) return shown(bar, v.value);
  return fmt::format("{} ({} - {})", shown(bar, v.value), shown(bar, v.low), shown(bar, v.high));
}

std::string asked(const DrillBar& bar) {
  std::string text;
  if (std::isfinite(bar.at_least)) text += ">= " + shown(bar, bar.at_least);
  if (std::isfinite(bar.at_most)) text += (text.empty() ? "<= " : ", <= ") + shown(bar, bar.at_most);
  return text;
}

std::string what(const DrillBar& bar) {
  std::string text = bar.start.empty() ? "" : bar.start + ": ";
  text += nameOf(bar.value);
  if (bar.statistic == DrillStatistic::kMedian || bar.statistic == DrillStatistic::kP95) {
    text += fmt::format(" {}", nameOf(bar.statistic));
  }
  if (!std::isfinite(bar.within)) return text;
  const bool length = bar.value == DrillMeasure::kError;
  return text + (length ? fmt::format(" <= {:.3g} cm", 100.0 * bar.within)
                        : fmt::format(" <= {:.3g} s", bar.within));
}

std::string verdictOf(const DrillReport& report) {
  if (!report.offered) return "not offered";
  return report.passed() ? "passed" : "failed";
}

std::string cell(const DrillReport& report) {
  if (!report.offered || report.passed()) return verdictOf(report);
  const auto reached = std::count_if(report.verdicts.begin(), report.verdicts.end(),
                                     [](const DrillVerdict& v) { return v.passed; });
  return fmt::format("{} / {}", reached, report.verdicts.size());
}

nlohmann::ordered_json number(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json jsonOf(const DrillVerdict& verdict) {
  const DrillBar& bar = verdict.bar;
  return {{"start", bar.start},
          {"measure", nameOf(bar.value)},
          {"statistic", nameOf(bar.statistic)},
          {"within", number(bar.within)},
          {"count", verdict.count},
          {"value", number(verdict.value.value)},
          {"low", number(verdict.value.low)},
          {"high", number(verdict.value.high)},
          {"at_least", number(bar.at_least)},
          {"at_most", number(bar.at_most)},
          {"of_least", bar.of_least},
          {"passed", verdict.passed}};
}

}  // namespace

std::string drillTable(const std::vector<DrillReport>& reports, const DrillOptions& options) {
  std::string out = fmt::format("## Drills of {} (seed {}, robot {}, physics {})\n\n", options.team.text,
                                options.seed, options.robot, options.physics);
  out += "| drill | measure | trials | value (95 %) | bar | verdict |\n|---|---|---|---|---|---|\n";
  for (const DrillReport& report : reports) {
    const std::string title = fmt::format("{} {}", report.drill.number, report.drill.name);
    if (!report.offered) {
      out += fmt::format("| {} | {} | - | - | - | not offered |\n", title, report.drill.what);
      continue;
    }
    bool first = true;
    for (const DrillVerdict& verdict : report.verdicts) {
      out += fmt::format("| {} | {} | {} | {} | {} | {} |\n", first ? title : "", what(verdict.bar),
                         verdict.count, measured(verdict), asked(verdict.bar),
                         verdict.passed ? "passed" : "failed");
      first = false;
    }
  }
  int passed = 0;
  for (const DrillReport& report : reports) passed += report.passed() ? 1 : 0;
  return out + fmt::format("\n{} of {} drills passed.\n", passed, reports.size());
}

std::string drillOverview(const std::vector<std::string>& teams,
                          const std::vector<std::vector<DrillReport>>& reports) {
  std::string out = "| drill |";
  std::string line = "|---|";
  for (const std::string& team : teams) {
    out += fmt::format(" {} |", team);
    line += "---|";
  }
  out += "\n" + line + "\n";
  for (std::size_t row = 0; row < reports.front().size(); ++row) {
    const Drill& drill = reports.front()[row].drill;
    out += fmt::format("| {} {} |", drill.number, drill.name);
    for (const auto& team : reports) out += fmt::format(" {} |", cell(team[row]));
    out += "\n";
  }
  out += "| passed |";
  for (const auto& team : reports) {
    const auto passed =
        std::count_if(team.begin(), team.end(), [](const DrillReport& r) { return r.passed(); });
    out += fmt::format(" {} of {} |", passed, team.size());
  }
  return out + "\n\nm / n: the team failed the drill but reached m of its n bars.\n";
}

std::string drillJson(const std::vector<DrillReport>& reports, const DrillOptions& options) {
  nlohmann::ordered_json json;
  json["schema_version"] = 1;
  json["team"] = options.team.text;
  json["seed"] = options.seed;
  json["robot"] = options.robot;
  json["physics"] = options.physics;
  json["build"] = buildInfo().version;
  json["drills"] = nlohmann::ordered_json::array();
  for (const DrillReport& report : reports) {
    nlohmann::ordered_json bars = nlohmann::ordered_json::array();
    for (const DrillVerdict& verdict : report.verdicts) bars.push_back(jsonOf(verdict));
    json["drills"].push_back({{"number", report.drill.number},
                              {"name", report.drill.name},
                              {"what", report.drill.what},
                              {"source", report.drill.source},
                              {"verdict", verdictOf(report)},
                              {"bars", std::move(bars)}});
  }
  return escapedJson(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace)) + "\n";
}

}  // namespace fulbito
