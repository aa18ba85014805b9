#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "engine/core/base/text_controls.hpp"
#include "fulbito/detail/build_info.hpp"
#include "fulbito/experiment.hpp"
#include "trials/comparison/paper_bars.hpp"
#include "trials/comparison/paper_figures.hpp"
#include "trials/comparison/paper_plan.hpp"

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchemaVersion = 1;

std::string hex(std::uint64_t value) { return fmt::format("{:016x}", value); }

Json buildJson() {
  const BuildInfo& build = buildInfo();
  return {
      {"version", build.version}, {"compiler", build.compiler}, {"type", build.type}, {"box2d", build.box2d}};
}

/// JSON has no NaN: null means "no value".
Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json summaryJson(const SummaryRow& row) {
  return {{"suite", row.suite},
          {"speed", row.speed},
          {"navigator", row.navigator},
          {"plans_speed", row.plans_speed},
          {"trials", row.trials},
          {"success_rate", row.success.value},
          {"success_low", row.success.low},
          {"success_high", row.success.high},
          {"contacts", row.contacts},
          {"own_contact_trials", row.own_contacts},
          {"stuck_over_2s_trials", row.stuck_over_2s},
          {"safe_pairs", row.safe_pairs},
          {"length_ratio", row.success.value > 0.0 ? Json(row.length_ratio) : Json(nullptr)},
          {"time_ratio", row.success.value > 0.0 ? Json(row.time_ratio) : Json(nullptr)},
          {"time_ratio_all", row.time_ratio_all},
          {"path_length_m", row.success.value > 0.0 ? Json(row.path_length) : Json(nullptr)},
          {"time_s", row.success.value > 0.0 ? Json(row.time) : Json(nullptr)},
          {"min_clearance_m", row.min_clearance},
          {"mean_min_clearance_m", row.success.value > 0.0 ? Json(row.mean_min_clearance) : Json(nullptr)},
          {"turning_rad", row.success.value > 0.0 ? Json(row.turning) : Json(nullptr)},
          {"curvature_jumps", row.success.value > 0.0 ? Json(row.curvature_jumps) : Json(nullptr)},
          {"wheel_jerk_m_s3", row.success.value > 0.0 ? Json(row.wheel_jerk) : Json(nullptr)},
          {"compute_us_p50", row.compute_us_p50},
          {"compute_us_p99", row.compute_us_p99},
          {"compute_us_max", row.compute_us_max}};
}

Json configJson(const Comparison& comparison) {
  const ComparisonConfig& c = comparison.config;
  Json navigators = Json::array(), speeds = Json::array();
  for (const std::string& n : c.navigators) navigators.push_back(n);
  for (double s : c.speeds) speeds.push_back(s);
  Json config = {{"suite", c.suite},
                 {"seed", c.seed},
                 {"trials", c.trials},
                 {"navigators", navigators},
                 {"speeds", speeds},
                 {"robot", c.robot},
                 {"physics", c.physics},
                 {"latency_ticks", c.sensors.latency_ticks},
                 {"noise_m", c.sensors.position_noise},
                 {"dropout", c.sensors.dropout}};
  if (c.only) config["only"] = *c.only;
  return config;
}

Json scoreJson(const TrialScore& s) {
  return {{"outcome", std::string(nameOf(s.outcome))},
          {"arrived", s.arrived},
          {"time_s", s.time},
          {"path_length_m", s.length},
          {"time_limit_s", s.time_limit},
          {"length_limit_m", s.length_limit},
          {"time_ratio", s.timeRatio()},
          {"length_ratio", s.lengthRatio()},
          {"obstacle_contacts", s.obstacle_contacts},
          {"wall_contacts", s.wall_contacts},
          {"own_contacts", s.own_contacts},
          {"contact_impulse_kg_m_s", s.contact_impulse},
          {"min_clearance_m", s.min_clearance},
          {"mean_clearance_m", s.mean_clearance},
          {"turning_rad", s.turning},
          {"curvature_jumps", s.curvature_jumps},
          {"wheel_jerk_m_s3", s.wheel_jerk},
          {"heading_error_rad", s.heading_error},
          {"longest_stuck_s", s.longest_stuck}};
}

Json barsJson(const PaperBars& bars) {
  Json layouts = Json::array();
  for (const LayoutPair& pair : bars.pairs) {
    layouts.push_back({{"index", pair.index},
                       {"field_length_m", pair.field_length},
                       {"field_time_s", pair.field_time},
                       {"bezier_length_m", pair.bezier_length},
                       {"bezier_time_s", pair.bezier_time}});
  }
  return {{"figure", bars.paper->figure},
          {"suite", bars.suite},
          {"speed", bars.speed},
          {"field", bars.field},
          {"bezier", bars.bezier},
          {"layouts", std::move(layouts)},
          {"bezier_slower", slowerPairs(bars)},
          {"bezier_longer", longerPairs(bars)}};
}

Json figureJson(const FigureRow& row) {
  Json runs = Json::array();
  for (const JudgedRun& run : row.runs) {
    runs.push_back({{"navigator", run.run->navigator},
                    {"judged", run.run->judged},
                    {"here", run.verdict.measured},
                    {"shows", run.verdict.shown}});
  }
  return {{"case", row.figure->layout.name}, {"paper", row.figure->sentence},
          {"rule", ruleText(*row.figure)},   {"speed", row.speed},
          {"shown", verdictOf(row)},         {"runs", std::move(runs)}};
}

}  // namespace

std::string resultsJson(const Comparison& comparison, double wall_seconds) {
  Json json = {{"schema_version", kSchemaVersion}, {"suite", comparison.config.suite},
               {"seed", comparison.config.seed},   {"build", buildJson()},
               {"config", configJson(comparison)}, {"summary", Json::array()}};
  for (const SummaryRow& row : comparison.summary) json["summary"].push_back(summaryJson(row));
  if (!comparison.reproduction.empty()) {
    json["reproduction"] = Json::array();
    for (const ReproductionRow& row : comparison.reproduction) {
      json["reproduction"].push_back(
          {{"id", row.id},
           {"claim", row.claim},
           {"paper", row.paper},
           {"ours", row.ours},
           {"off_paper_points", row.off_paper ? Json(*row.off_paper) : Json(nullptr)},
           {"our_band", row.our_band},
           {"inside_our_band", row.inside_our_band},
           {"reason", row.reason}});
    }
  }
  if (comparison.config.suite == kPaperSuite) {
    for (const PaperBars& bars : paperBars(comparison)) json["bars"].push_back(barsJson(bars));
  }
  for (const FigureRow& row : judgeFigures(comparison)) json["figures"].push_back(figureJson(row));
  for (const FigureRow& row : judgeSweeps(comparison)) {
    Json place = figureJson(row);
    place["what"] = nameOf(row.figure->sweep.kind);
    place["value"] = row.value;
    json["sweeps"].push_back(std::move(place));
  }
  json["wall_seconds"] = numberOrNull(wall_seconds);
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string trialJson(const TrialConfig& config, const TrialResult& result) {
  std::vector<double> compute = result.compute_us;
  Json json = {{"schema_version", kSchemaVersion},
               {"layout", config.layout.name},
               {"navigator", config.navigator.text},
               {"speed", config.robot.robot.maxSpeed()},
               {"robot", config.robot.robot.name},
               {"physics", config.physics.name},
               {"seed", config.seed},
               {"build", buildJson()},
               {"score", scoreJson(result.score)},
               {"final_hash", hex(result.final_hash)},
               {"compute_us_p50", numberOrNull(quantile(compute, 0.5))},
               {"compute_us_p99", numberOrNull(quantile(compute, 0.99))},
               {"compute_us_max", numberOrNull(quantile(compute, 1.0))}};
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

std::string versionJson() {
  Json json = buildJson();
  json["schema_version"] = kSchemaVersion;
  return escapedJson(json.dump(2, ' ', false, Json::error_handler_t::replace)) + "\n";
}

}  // namespace fulbito
