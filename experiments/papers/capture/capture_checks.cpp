#include <cmath>

#include "experiments/papers/capture/capture_results.hpp"
#include "experiments/papers/capture/fig18.hpp"
#include "experiments/papers/capture/paper_tables.hpp"
#include "experiments/papers/capture/slip_fit.hpp"
#include "fulbito/models.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;
constexpr double kPrintedTime = 30.2;  // [s] printed time of the capture

ReportTable crossTable() {
  ReportTable table{
      "slip-cross-validation",
      "Slip fitted to the radii of one table, and what it says of the other",
      columnsOf("fitted_to:0 tau0_s:3 tau1_s2pm:3 rms_m:3 worst_m:3 says_of:0 rms_there_m:3 worst_there_m:3"),
      {}};
  const auto add = [&](const char* own, const std::vector<DrivenRadius>& radii, const char* other,
                       const std::vector<DrivenRadius>& unseen) {
    const SlipFit law = fitWidening(radii), there = judgedOn(law, unseen);
    table.rows.push_back({std::string(own), law.tau0, law.tau1, law.rms, law.worst, std::string(other),
                          there.rms, there.worst});
  };
  add("Table 5", radiiOfTable5(), "Table 6", radiiOfTable6());
  add("Table 6", radiiOfTable6(), "Table 5", radiiOfTable5());
  return table;
}

/// The distance [m] that a robot drives at constant speed in the printed time, which includes v / 2a for
/// acceleration.
double wayIn(double time, double speed) { return (time - speed / (2 * PaperTables::kAcceleration)) * speed; }

ReportTable timesTable() {
  ReportTable table{"times-and-distances",
                    "The paper against itself: the way (t - v / 2a) v of its times beside its distances",
                    columnsOf("v_mps:1 table_5_time_s:1 table_5_way_m:2 table_5_distance_m:2 "
                              "table_6_time_s:1 table_6_way_m:2 table_6_distance_m:2 table_6_difference_m:2"),
                    {}};
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const double v = PaperTables::kSpeeds[i];
    const PaperTables::Single& one = PaperTables::kSingle[i];
    const PaperTables::Double& two = PaperTables::kDouble[i];
    const double way = wayIn(two.time, v);
    table.rows.push_back(
        {v, one.time, wayIn(one.time, v), one.distance, two.time, way, two.distance, way - two.distance});
  }
  return table;
}

ReportTable changeTable(const CaptureResults& results) {
  ReportTable table{
      "table-6-changes",
      "Table 6 by the change between the curves: each wheel at 0.05 m/s^2 and full speed, or at "
      "once",
      columnsOf(
          "v_mps:1 paper_time_s:1 gradual_time_s:1 instant_time_s:1 paper_distance_m:2 gradual_distance_m:2 "
          "instant_distance_m:2 paper_error_m:2 gradual_error_m:2 instant_error_m:2"),
      {}};
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const double v = PaperTables::kSpeeds[i];
    const PaperTables::Double& paper = PaperTables::kDouble[i];
    const CurveDriveResult &gradual = results.curves.both[i].driven,
                           &instant = results.curves.both[i].instant;
    table.rows.push_back({v, paper.time, timeOf(gradual, v), timeOf(instant, v), paper.distance,
                          gradual.distance, instant.distance, paper.error, gradual.end_error,
                          instant.end_error});
  }
  return table;
}

/// The first turn [rad] of the plan with the duration `time` [s]. Smaller turns give longer plans.
double turnOfTime(double time) {
  double low = 0.5 * fig18Turn(0.546), high = fig18Turn(0.546);
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    const auto plan = fig18Plan(middle);
    (plan && plan->motion.duration() < time ? high : low) = middle;
  }
  return high;
}

ReportTable planTable() {
  ReportTable table{"plans",
                    "Plans of Fig. 18 without slip by the first turn: the printed speed and the printed time "
                    "exclude each other",
                    columnsOf("plan:0 turn_1_deg:2 time_1_s:2 top_speed_mps:3 time_s:2 gap_m:3"),
                    {}};
  const auto add = [&](const char* name, double turn) {
    const auto plan = fig18Plan(turn);
    if (!plan) return;
    table.rows.push_back({std::string(name), turn / kDegree, plan->time1, plan->top_speed,
                          plan->motion.duration(), plan->gap});
  };
  const double printed = fig18Turn(0.546);
  add("printed 0.546 m/s, the largest turn", printed);
  add("printed 30.2 s", turnOfTime(kPrintedTime));
  add("0.95 of the largest turn", 0.95 * printed);
  add("0.90", 0.90 * printed);
  add("0.85", 0.85 * printed);
  return table;
}

ReportTable againTable(const CaptureResults& results) {
  ReportTable table{"sightings-again",
                    "Fig. 18 again, each time with other errors of the sightings",
                    columnsOf("draw:0 seen_speed_error_mps:4 seen_heading_error_deg:2 turn_1_deg:1 "
                              "top_speed_mps:3 time_s:2 gap_m:3 heading_deg:2"),
                    {},
                    10};
  for (const PursuitResult& run : results.again) {
    const Vec2 seen = run.estimates.front().velocity, truth = fig18Object().velocity;
    table.rows.push_back({static_cast<double>(table.rows.size()), norm(seen) - norm(truth),
                          math::wrapAngle(math::angleOf(seen) - math::angleOf(truth)) / kDegree,
                          run.driven.turn1 / kDegree, run.driven.top_speed, run.time, run.gap,
                          run.heading / kDegree});
  }
  return table;
}

}  // namespace

void addChecks(const CaptureResults& results, ExperimentReport& report) {
  for (ReportTable& table :
       std::vector{crossTable(), timesTable(), changeTable(results), planTable(), againTable(results)})
    report.tables.push_back(std::move(table));
}

}  // namespace fulbito::capture
