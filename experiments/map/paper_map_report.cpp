#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/base/text_controls.hpp"
#include "experiments/map/paper_map.hpp"
#include "fulbito/detail/build_info.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;
constexpr std::size_t kMostListed = 8;  // greatest number of a region's cells in the text; map.csv has all

const char* lawOf(const MapCell& cell) { return cell.classic ? "classic" : "preview"; }

std::string placeText(const MapCell& cell) {
  return fmt::format("{}, radius {:.1f} cm, width {:.1f} cm, {} law, {:.1f} m/s, start heading {}",
                     cell.suite, 100 * cell.radius, 100 * cell.width, lawOf(cell), cell.speed,
                     nameOf(cell.heading));
}

std::string percent(double value) { return std::isnan(value) ? "-" : fmt::format("{:+.1f} %", 100 * value); }

std::string gapText(const MapGap& gap) {
  return fmt::format("distance {} ({:+.1f} ... {:+.1f}), time {} ({:+.1f} ... {:+.1f}), {} safe pairs",
                     percent(gap.length.value), 100 * gap.length.low, 100 * gap.length.high,
                     percent(gap.time.value), 100 * gap.time.low, 100 * gap.time.high, gap.pairs);
}

std::string cellText(const MapCell& cell, bool with_hung) {
  return fmt::format("{}: {}; ring safe in {:.0f} % ({:.0f}-{:.0f}) of {}", placeText(cell),
                     gapText(with_hung ? cell.raw : cell.cut), 100 * cell.safe.value, 100 * cell.safe.low,
                     100 * cell.safe.high, cell.trials);
}

void appendFinding(std::string& out, const PaperMap& map, const MapFinding& finding) {
  out += fmt::format("- **{}: {}, {:+.1f} % distance and {:+.1f} % time, {}**: ", finding.suite,
                     finding.target.name, 100 * finding.target.length, 100 * finding.target.time,
                     finding.with_hung ? "with hung runs" : "without hung runs");
  if (std::isnan(finding.off)) {
    out += fmt::format("no cell has {} safe pairs.\n", kLeastMapPairs);
    return;
  }
  if (finding.region.empty()) {
    out += fmt::format("no cell within {:.0f} points. The nearest is {:.1f} points off: {}.\n",
                       100 * kTargetTolerance, 100 * finding.off,
                       cellText(map.cells[finding.nearest], finding.with_hung));
    return;
  }
  out += fmt::format("{} cell{} within {:.0f} points:\n", finding.region.size(),
                     finding.region.size() == 1 ? "" : "s", 100 * kTargetTolerance);
  for (std::size_t i = 0; i < std::min(kMostListed, finding.region.size()); ++i) {
    out += fmt::format("  - {}\n", cellText(map.cells[finding.region[i]], finding.with_hung));
  }
  if (finding.region.size() > kMostListed) out += "  - ... (map.csv has all)\n";
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json gapJson(const MapGap& gap) {
  return {{"pairs", gap.pairs},
          {"distance", number(gap.length.value)},
          {"distance_low", number(gap.length.low)},
          {"distance_high", number(gap.length.high)},
          {"time", number(gap.time.value)},
          {"time_low", number(gap.time.low)},
          {"time_high", number(gap.time.high)}};
}

Json cellJson(const MapCell& cell) {
  return {{"suite", cell.suite},
          {"radius_m", cell.radius},
          {"width_m", cell.width},
          {"law", lawOf(cell)},
          {"speed", cell.speed},
          {"heading", std::string(nameOf(cell.heading))},
          {"trials", cell.trials},
          {"safe_share", cell.safe.value},
          {"safe_low", cell.safe.low},
          {"safe_high", cell.safe.high},
          {"bezier_safe_share", cell.bezier_safe.value},
          {"time_ratio_all", cell.time_ratio_all},
          {"cut", gapJson(cell.cut)},
          {"raw", gapJson(cell.raw)}};
}

Json findingJson(const MapFinding& finding) {
  Json json = {
      {"suite", finding.suite},      {"target", finding.target.name},  {"distance", finding.target.length},
      {"time", finding.target.time}, {"with_hung", finding.with_hung}, {"region", finding.region},
      {"nearest", nullptr},          {"off", number(finding.off)}};
  if (!std::isnan(finding.off)) json["nearest"] = finding.nearest;
  return json;
}

Json freshJson(const FreshCell& fresh) {
  Json json = {{"cell", fresh.cell},
               {"safe_share", fresh.safe.value},
               {"cut", gapJson(fresh.cut)},
               {"raw", gapJson(fresh.raw)},
               {"cut_by_seed", Json::array()}};
  for (const MapGap& gap : fresh.by_seed) json["cut_by_seed"].push_back(gapJson(gap));
  return json;
}

}  // namespace

std::string mapReport(const PaperMap& map) {
  const MapConfig& config = map.config;
  std::string out = fmt::format(
      "## Map of the ring field, {} (seeds {} ... {}, {} layouts each, robot {}, physics {})\n\n"
      "{} cells; each compares the Bezier method with one ring under the same law, on the layouts that both "
      "solved. A run longer than 4 T* counts as hung.\n\n### Cells that match both of the paper's "
      "figures\n\n",
      fmt::join(config.suites, " and "), config.base.seed,
      config.base.seed + static_cast<std::uint64_t>(config.seeds - 1), config.base.trials,
      map.comparison.robot.robot.name, map.comparison.physics.name, map.cells.size());
  for (const MapFinding& finding : map.findings) appendFinding(out, map, finding);
  out += freshReport(map);
  out +=
      "\n### The safest ring per suite, law, start and speed (chosen by its own safety, then its "
      "time)\n\n"
      "| suite | law | start heading | m/s | radius cm | width cm | safe (95 %) | T/T* all | distance, time "
      "without "
      "hung | "
      "pairs | distance, time with hung | pairs |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (std::size_t i : safestCells(map.cells)) {
    const MapCell& c = map.cells[i];
    out += fmt::format(
        "| {} | {} | {} | {:.1f} | {:.1f} | {:.1f} | {:.0f} % ({:.0f}-{:.0f}) | {:.2f} | {}, {} | {} | {}, "
        "{} | "
        "{} |\n",
        c.suite, lawOf(c), nameOf(c.heading), c.speed, 100 * c.radius, 100 * c.width, 100 * c.safe.value,
        100 * c.safe.low, 100 * c.safe.high, c.time_ratio_all, percent(c.cut.length.value),
        percent(c.cut.time.value), c.cut.pairs, percent(c.raw.length.value), percent(c.raw.time.value),
        c.raw.pairs);
  }
  out +=
      "\n### One ring for all laws, starts and speeds (least mean T/T* of its own runs, failures as 8)\n\n";
  for (const std::string& suite : config.suites) {
    const RingRecord ring = bestRing(map.cells, suite);
    out += fmt::format(
        "- {}: radius {:.1f} cm, width {:.1f} cm: T/T* {:.2f}, safe in {:.0f} % on average, in {:.0f} % "
        "where "
        "it is least\n",
        suite, 100 * ring.radius, 100 * ring.width, ring.time_ratio_all, 100 * ring.safe,
        100 * ring.least_safe);
  }
  return out;
}

std::string mapCsv(const PaperMap& map) {
  std::string out =
      "suite,radius_m,width_m,law,speed,heading,trials,safe_share,safe_low,safe_high,bezier_safe_share,time_"
      "ratio_"
      "all,pairs,distance,distance_low,distance_high,time,time_low,time_high,raw_pairs,raw_distance,raw_"
      "distance_low,raw_distance_high,raw_time,raw_time_low,raw_time_high\n";
  const auto value = [](double v) { return std::isfinite(v) ? fmt::format("{}", v) : std::string(); };
  for (const MapCell& c : map.cells) {
    out += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{}", c.suite, c.radius, c.width, lawOf(c), c.speed,
                       nameOf(c.heading), c.trials, c.safe.value, c.safe.low, c.safe.high,
                       c.bezier_safe.value, c.time_ratio_all);
    for (const MapGap* gap : {&c.cut, &c.raw}) {
      out += fmt::format(",{},{},{},{},{},{},{}", gap->pairs, value(gap->length.value),
                         value(gap->length.low), value(gap->length.high), value(gap->time.value),
                         value(gap->time.low), value(gap->time.high));
    }
    out += '\n';
  }
  return out;
}

std::string mapJson(const PaperMap& map, double wall_seconds) {
  const MapConfig& config = map.config;
  const BuildInfo& build = buildInfo();
  Json json = {{"schema_version", kSchemaVersion},
               {"kind", "map"},
               {"suites", config.suites},
               {"seed", config.base.seed},
               {"build",
                {{"version", build.version},
                 {"compiler", build.compiler},
                 {"type", build.type},
                 {"box2d", build.box2d}}},
               {"config",
                {{"seeds", config.seeds},
                 {"trials", config.base.trials},
                 {"fresh", config.fresh},
                 {"radii_m", config.radii},
                 {"widths_m", config.widths},
                 {"laws", config.laws},
                 {"speeds", config.base.speeds},
                 {"headings", config.headings},
                 {"robot", config.base.robot},
                 {"physics", config.base.physics},
                 {"latency_ticks", config.base.sensors.latency_ticks},
                 {"noise_m", config.base.sensors.position_noise},
                 {"dropout", config.base.sensors.dropout}}},
               {"cells", Json::array()},
               {"findings", Json::array()},
               {"fresh", Json::array()}};
  for (const MapCell& cell : map.cells) json["cells"].push_back(cellJson(cell));
  for (const MapFinding& finding : map.findings) json["findings"].push_back(findingJson(finding));
  for (const FreshCell& fresh : map.fresh) json["fresh"].push_back(freshJson(fresh));
  json["safest"] = safestCells(map.cells);
  json["wall_seconds"] = number(wall_seconds);
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace fulbito
