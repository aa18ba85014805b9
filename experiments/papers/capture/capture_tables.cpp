#include "experiments/papers/capture/capture_results.hpp"
#include "experiments/papers/capture/fig18.hpp"
#include "experiments/papers/capture/paper_tables.hpp"
#include "experiments/papers/capture/slip_fit.hpp"
#include "fulbito/models.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;

ReportTable wheelTable(const CaptureResults& results) {
  ReportTable table{"table-4",
                    "Table 4: wheel speeds and time without slip, driven from rest",
                    columnsOf("v_mps:1 time_s:2 paper_time_s:1 single_left_mps:3 single_right_mps:3 "
                              "double_left_mps:3 double_right_mps:3"),
                    {}};
  const double radius = results.robot.wheel_radius;
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const double v = PaperTables::kSpeeds[i];
    // The printed wheels of the double trajectory are those of its second curve, to the left.
    const WheelSpeeds single = inverseKinematics(results.robot, {v, -v / PaperTables::kSingleRadius});
    const WheelSpeeds both = inverseKinematics(results.robot, {v, v / PaperTables::kDoubleRadius});
    table.rows.push_back({v, results.curves.single[i].ideal.time, PaperTables::kComputed[i].time,
                          single.left * radius, single.right * radius, both.left * radius,
                          both.right * radius});
  }
  return table;
}

ReportTable singleTable(const CaptureResults& results) {
  ReportTable table{"table-5",
                    "Table 5: the single curve, at speed from the first metre",
                    columnsOf("v_mps:1 radius_m:3 paper_radius_m:2 radius_error_m:3 paper_error_m:2 "
                              "end_error_m:3 time_s:2 paper_time_s:1 distance_m:3 paper_distance_m:2"),
                    {}};
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const CurveRow& row = results.curves.single[i];
    const PaperTables::Single& paper = PaperTables::kSingle[i];
    table.rows.push_back({PaperTables::kSpeeds[i], row.driven.radius1, paper.radius,
                          row.driven.radius1 - PaperTables::kSingleRadius, paper.error, row.driven.end_error,
                          row.time(PaperTables::kSpeeds[i]), paper.time, row.driven.distance,
                          paper.distance});
  }
  return table;
}

ReportTable doubleTable(const CaptureResults& results) {
  ReportTable table{
      "table-6",
      "Table 6: the double curve, at speed from the first metre",
      columnsOf("v_mps:1 radius_1_m:3 paper_radius_1_m:2 radius_2_m:3 paper_radius_2_m:2 end_error_m:3 "
                "paper_error_m:2 error_ratio:2 time_s:2 paper_time_s:1 distance_m:3 paper_distance_m:2"),
      {}};
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const CurveRow& row = results.curves.both[i];
    const PaperTables::Double& paper = PaperTables::kDouble[i];
    table.rows.push_back({PaperTables::kSpeeds[i], row.driven.radius1, paper.radius1, row.driven.radius2,
                          paper.radius2, row.driven.end_error, paper.error,
                          row.driven.end_error / paper.error, row.time(PaperTables::kSpeeds[i]), paper.time,
                          row.driven.distance, paper.distance});
  }
  return table;
}

ReportTable startedTable(const CaptureResults& results) {
  ReportTable table{"from-rest",
                    "The same from rest: while the robot speeds up it slips less",
                    columnsOf("v_mps:1 single_time_s:2 single_distance_m:3 single_end_error_m:3 "
                              "double_time_s:2 double_distance_m:3 double_end_error_m:3 end_error_ratio:2"),
                    {}};
  for (std::size_t i = 0; i < PaperTables::kSpeeds.size(); ++i) {
    const CurveDriveResult& one = results.curves.single[i].started;
    const CurveDriveResult& two = results.curves.both[i].started;
    table.rows.push_back({PaperTables::kSpeeds[i], one.time, one.distance, one.end_error, two.time,
                          two.distance, two.end_error, two.end_error / one.end_error});
  }
  return table;
}

ReportTable slipTable() {
  ReportTable table{"slip-laws",
                    "Laws of the radius under slip, fitted to the 15 radii of Tables 5 and 6",
                    columnsOf("law:0 tau0_s:3 tau1_s2pm:3 rms_m:3 worst_m:3"),
                    {}};
  const std::vector<DrivenRadius> radii = publishedRadii();
  const auto add = [&](const char* law, const SlipFit& fit) {
    table.rows.push_back({std::string(law), fit.tau0, fit.tau1, fit.rms, fit.worst});
  };
  add("R + tau0 v + tau1 v^2", fitWidening(radii));
  add("R + tau0 v", fitLinearWidening(radii));
  add("R (1 + tau1 v^2)", fitUndersteer(radii));
  return table;
}

ReportTable estimatorTable(const CaptureResults& results) {
  ReportTable table{
      "estimators",
      "Errors (rms) of the object's motion from noisy sightings",
      columnsOf(
          "range_noise_m:3 bearing_noise_deg:2 method:0 sightings:0 position_m:4 speed_mps:4 heading_deg:2"),
      {}};
  for (const EstimatorRow& row : results.estimators) {
    table.rows.push_back({row.noise.range, row.noise.bearing / kDegree, row.method,
                          static_cast<double>(row.sightings), row.position, row.speed,
                          row.heading / kDegree});
  }
  return table;
}

ReportTable captureTable(const CaptureResults& results) {
  ReportTable table{"capture",
                    "Fig. 18: the capture in the world",
                    columnsOf("way:0 turn_1_deg:1 radius_3_m:2 line_m:2 planned_s:2 time_s:2 gap_m:3 "
                              "aside_m:3 speed_mps:4 heading_deg:2 fastest_wheel_mps:3 touched:0"),
                    {}};
  for (const Fig18Run& run : results.runs) {
    const PursuitResult& r = run.result;
    table.rows.push_back({run.way, r.driven.turn1 / kDegree, r.driven.radius3, r.driven.line,
                          r.answer.plan->motion.duration(), r.time, r.gap, r.aside, r.speed,
                          r.heading / kDegree, r.largest_rim, std::string(r.touched ? "yes" : "no")});
  }
  return table;
}

ReportTable randomTable(const CaptureResults& results) {
  ReportTable table{"random-captures",
                    "Random captures: both bodies in one world",
                    columnsOf("draw:0 speed_mps:3 time_s:2 gap_error_m:3 aside_m:3 speed_error_mps:4 "
                              "heading_error_deg:2 fastest_wheel_mps:3 touched:0 caught:0"),
                    {},
                    10};
  for (const RandomCapture& c : results.random.captures) {
    table.rows.push_back({static_cast<double>(c.index), norm(c.setup.object.velocity), c.time, c.gap_error,
                          c.aside, c.speed_error, c.heading_error / kDegree, c.largest_rim,
                          std::string(c.touched ? "yes" : "no"), std::string(c.caught() ? "yes" : "no")});
  }
  return table;
}

ReportTable refusalTable(const CaptureResults& results) {
  ReportTable table{"refused", "Draws of random captures without a plan", columnsOf("reason:0 draws:0"), {}};
  for (std::size_t i = 0; i < results.random.refused.size(); ++i) {
    table.rows.push_back(
        {nameOf(static_cast<CaptureRefusal>(i)), static_cast<double>(results.random.refused[i])});
  }
  return table;
}

}  // namespace

void addTables(const CaptureResults& results, ExperimentReport& report) {
  report.tables = {wheelTable(results),   singleTable(results), doubleTable(results),
                   startedTable(results), slipTable(),          estimatorTable(results),
                   captureTable(results), randomTable(results), refusalTable(results)};
}

}  // namespace fulbito::capture
