#include "experiments/papers/transport/transport_report.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/papers/transport/path_fit.hpp"
#include "experiments/papers/transport/phases.hpp"
#include "fulbito/models.hpp"

namespace fulbito {
namespace {

double cm(double metres) { return metres * 100.0; }
double mm(double metres) { return metres * 1000.0; }
double degrees(double angle) { return angle * 180.0 / math::kPi; }
double countOf(std::size_t count) { return static_cast<double>(count); }

const char* nameOfCarrier(CarrierId id) { return id == CarrierId::kLead ? "lead" : "follower"; }
const char* directionName(double speed) { return speed < 0.0 ? "backward" : "forward"; }

const char* endName(StopReason reason) {
  switch (reason) {
    case StopReason::kNone:
      return "time is up";
    case StopReason::kArrived:
      return "arrived";
    case StopReason::kOffPath:
      return "off the path";
    case StopReason::kDeadlock:
      return "deadlock";
    case StopReason::kSilence:
      return "silence";
  }
  return "";
}

/// For each phase, the numbers of the paper's steps in it, or "-".
std::vector<std::string> stepNames(const std::vector<Phase>& phases, double end) {
  std::vector<std::string> names(phases.size(), "-");
  for (const PaperStep& step : paperSteps(phases, end)) {
    std::string& name = names[step.phase];
    name = name == "-" ? fmt::format("{}", step.number) : fmt::format("{}, {}", name, step.number);
  }
  return names;
}

// Marks of the exchanges of roles. Those close together share a mark with several numbers.
std::vector<ChartMark> marksOf(const Carrying& work) {
  constexpr double kTogether = 0.015;  // share of the duration
  std::vector<ChartMark> marks;
  std::size_t labelled = 0;
  for (const RoleSwitch& s : work.switches) {
    const std::string number = fmt::format("{}", marks.size() + 1);
    const bool near = !marks.empty() && s.time - marks[labelled].x < kTogether * work.seconds;
    if (near) marks[labelled].label += "," + number;
    if (!near) labelled = marks.size();
    marks.push_back({s.time, near ? "" : number});
  }
  // Too many marks have no numbers at all.
  constexpr std::size_t kMostNumbers = 12;
  if (marks.size() > kMostNumbers) {
    for (ChartMark& mark : marks) mark.label.clear();
  }
  return marks;
}

std::string roleOf(CarrierId id, CarrierId master) { return id == master ? "master" : "slave"; }

std::vector<Vec2> sineWave() {
  std::vector<Vec2> points;
  for (int i = 0; i <= 150; ++i)
    points.push_back({0.02 * i, 0.3 * math::sin(0.02 * i * 2 * math::kPi / 1.5)});
  return points;
}

std::vector<Vec2> zigzag() {
  std::vector<Vec2> points;
  for (int i = 0; i <= 6; ++i) points.push_back({0.5 * i, i % 2 == 0 ? 0.0 : 0.4});
  return points;
}

std::vector<Vec2> spiral() {
  std::vector<Vec2> points;
  for (int i = 0; i <= 120; ++i) points.push_back(math::unit(0.1 * i) * (0.3 + 0.01 * i));
  return points;
}

std::vector<ReportCell> fitRow(const std::string& name, const std::vector<Vec2>& points) {
  const Result<PartPath> path = fitPath(points);
  return {name, countOf(points.size()), countOf(path->size()), path->length(),
          mm(distanceBetween(*path, points))};
}

}  // namespace

ReportTable partTable(const TransportTask& task) {
  ReportTable table{"table-2",
                    "Parts of the path, as Table 2; radius, length and end are not in print",
                    columnsOf("number:0 shape x_cm:1 y_cm:1 angle_deg:1 radius_cm:1 from_cm:1 to_cm:1"),
                    {}};
  for (std::size_t i = 0; i < task.path.size(); ++i) {
    const Arc& part = task.path.parts()[i];
    const bool line = part.curvature == 0.0;
    const Vec2 at = line ? part.start.position
                         : part.start.position + perp(math::unit(part.start.heading)) / part.curvature;
    table.rows.push_back({countOf(i + 1), std::string(line ? "line" : "arc"), cm(at.x), cm(at.y),
                          degrees(line ? part.start.heading : part.turn()),
                          line ? std::nan("") : cm(1.0 / std::abs(part.curvature)), cm(task.path.from(i)),
                          cm(task.path.to(i))});
  }
  return table;
}

ReportTable phaseTable(const Carrying& work) {
  ReportTable table{
      "table-1",
      "Roles and directions, as Table 1, with its steps where they fit",
      columnsOf("from_s:1 steps_of_table_1 lead_role lead_direction follower_role follower_direction"),
      {}};
  const std::vector<Phase> phases = phasesOf(work);
  const std::vector<std::string> steps = stepNames(phases, work.seconds);
  for (std::size_t i = 0; i < phases.size(); ++i) {
    const Phase& phase = phases[i];
    table.rows.push_back({phase.from, steps[i], roleOf(CarrierId::kLead, phase.master),
                          std::string(phase.lead_back ? "backward" : "forward"),
                          roleOf(CarrierId::kFollower, phase.master),
                          std::string(phase.follower_back ? "backward" : "forward")});
  }
  return table;
}

ReportTable switchTable(const Carrying& work) {
  ReportTable table{"switches",
                    "Exchanges of roles",
                    columnsOf("number:0 time_s:2 cause new_master direction lead_cm:1 follower_cm:1"),
                    {}};
  for (const RoleSwitch& s : work.switches)
    table.rows.push_back({countOf(table.rows.size() + 1), s.time,
                          std::string(s.cause == SwitchCause::kSpeed ? "speed" : "end of part"),
                          std::string(nameOfCarrier(s.master)), std::string(directionName(s.direction)),
                          cm(s.lead), cm(s.follower)});
  return table;
}

ReportTable stepTable(const std::vector<StepErrors>& steps) {
  ReportTable table{"rod-error",
                    "Largest error of the rod's length against the step, without and with projection",
                    columnsOf("step_s:2 euler_mm:3 projected_mm:4 switches:0 time_s:1 peak_cm_per_s:2"),
                    {}};
  for (const StepErrors& e : steps)
    table.rows.push_back({e.step, mm(e.euler.rod_error), mm(e.projected.rod_error),
                          countOf(e.projected.switches.size()), e.projected.seconds,
                          cm(e.projected.peak_speed)});
  return table;
}

ReportTable printedTable(const TransportTask& task, const std::vector<PrintedRun>& printed,
                         const Carrying& ours, double step) {
  ReportTable table{
      "fig-10-printed",
      "The path of 43 parts by the printed rules, and by a master that slows down in an impasse",
      columnsOf("rules projection step_s:2 result time_s:1 lead_m:2 path_m:2 exchanges:0 rod_error_mm:3"),
      {}};
  const auto add = [&](const char* rules, bool project, double length, const Carrying& work) {
    table.rows.push_back({std::string(rules), std::string(project ? "yes" : "no"), length,
                          std::string(endName(work.end)), work.seconds, work.lead, task.path.length(),
                          countOf(work.switches.size()), mm(work.rod_error)});
  };
  for (const PrintedRun& run : printed) add("as printed", run.project, run.step, run.work);
  add("ours", true, step, ours);
  return table;
}

ReportTable radioTable(const std::vector<RadioRun>& radios) {
  ReportTable table{"radio",
                    "Messages that get lost or come late: both robots stop, and go on",
                    columnsOf("radio result time_s:1 switches:0 rod_error_mm:3 broken_off_runs:0 "
                              "losses_of_contact:0 messages:0 lost:0 speed_percent:0"),
                    {}};
  for (const RadioRun& r : radios)
    table.rows.push_back({r.name, std::string(endName(r.work.end)), r.work.seconds,
                          countOf(r.work.switches.size()), mm(r.work.rod_error),
                          static_cast<double>(r.work.aborts), static_cast<double>(r.work.timeouts),
                          countOf(r.work.messages), countOf(r.work.lost), 100.0 * r.work.speed_share});
  return table;
}

ReportTable randomTable(const std::vector<RandomRun>& runs) {
  ReportTable table{"random-paths",
                    "Random paths: the pre-check, the independent contour, the robots",
                    columnsOf("path:0 parts:0 length_m:2 rod_m:2 result right switches:0 rod_error_mm:3 "
                              "peak_cm_per_s:2 as_printed why"),
                    {}};
  for (const RandomRun& r : runs)
    table.rows.push_back({countOf(table.rows.size()), countOf(r.task.path.size()), r.task.path.length(),
                          r.task.rod, std::string(r.accepted() ? endName(r.work.end) : "refused"),
                          std::string(r.right() ? "yes" : "no"), countOf(r.work.switches.size()),
                          mm(r.work.rod_error), cm(r.work.peak_speed), std::string(endName(r.printed.end)),
                          refusal(r.task, r.curve)});
  return table;
}

ReportTable realTable(const std::vector<RealRun>& runs) {
  ReportTable table{"real-rod",
                    "A rod of 1 kg on joints, carried by two robots of 2 kg whose wheels do 1.5 m/s^2",
                    columnsOf("speeds limit_cm_per_s:0 time_s:1 peak_force_N:3 rms_force_N:3 path_error_mm:2 "
                              "place_error_mm:2 rod_error_mm:3 end_gap_mm:2 peak_cm_per_s:1"),
                    {}};
  for (const RealRun& r : runs)
    table.rows.push_back({r.name, cm(r.pace), r.drive.seconds, r.drive.peak_force, r.drive.mean_force,
                          mm(r.drive.path_error), mm(r.drive.along_error), mm(r.drive.rod_error),
                          mm(r.drive.end_gap), cm(r.drive.peak_speed)});
  return table;
}

ReportTable fitTable() {
  const PartPath s_path = PartPath({{{{0, 0}, 0.0}, 0.0, 4.0},
                                    {{{4, 0}, 0.0}, 4.0, 0.25 * math::kPi},
                                    {{{4, 0.5}, -math::kPi}, 0.0, 3.0},
                                    {{{1, 0.5}, -math::kPi}, -4.0, 0.25 * math::kPi},
                                    {{{1, 1}, 0.0}, 0.0, 4.0}});
  ReportTable table{"fits",
                    "Polylines as lines and arcs, within 5 mm",
                    columnsOf("polyline points:0 parts:0 length_m:3 distance_mm:3"),
                    {}};
  table.rows.push_back(fitRow("S path, every 2 cm", pointsAlong(s_path, 0.02)));
  table.rows.push_back(fitRow("sine wave of 0.3 m, every 2 cm", sineWave()));
  table.rows.push_back(fitRow("spiral, every 0.1 rad", spiral()));
  table.rows.push_back(fitRow("zigzag with five corners", zigzag()));
  return table;
}

ReportChart speedChart(const std::string& name, const TransportTask& task, const Carrying& work) {
  LineChart chart;
  chart.title = "Speeds of both robots along the path";
  chart.caption = fmt::format("{} exchanges of roles: dashed marks. The master runs at {:g} cm/s.",
                              work.switches.size(), cm(task.speed));
  chart.x_axis = "time [s]";
  chart.y_axis = "speed [cm/s]";
  chart.lines = {{"leading robot", {}}, {"following robot", {}}};
  for (const CarryRow& row : work.rows) {
    chart.lines[0].points.push_back({row.time, cm(row.lead_speed)});
    chart.lines[1].points.push_back({row.time, cm(row.follower_speed)});
  }
  chart.marks = marksOf(work);
  return {name, chart};
}

ReportChart stepChart(const std::vector<StepErrors>& steps) {
  LineChart chart;
  chart.title = "Error of the rod's length against the step";
  chart.caption = "Without projection it is the sum of all steps' errors; with it, that within one step.";
  chart.x_axis = "log10 of the step [s]";
  chart.y_axis = "log10 of the largest error [mm]";
  chart.from_zero = false;
  chart.lines = {{"speeds of the relation alone", {}, true}, {"projected", {}, true}};
  // math::log, since the C library's logarithm differs between processors.
  const auto decades = [](double x) { return math::log(x) / math::log(10.0); };
  for (const StepErrors& e : steps) {
    chart.lines[0].points.push_back({decades(e.step), decades(mm(e.euler.rod_error))});
    chart.lines[1].points.push_back({decades(e.step), decades(mm(e.projected.rod_error))});
  }
  return {"rod-error", chart};
}

ReportChart curveChart(const PathWork& work) {
  LineChart chart;
  chart.title = "All pairs of places a rod's length apart, from the start on";
  chart.caption = "The pre-check follows this curve. Dots: exchanges of roles. Dashed: ends of parts.";
  chart.x_axis = "leading robot along the path [m]";
  chart.y_axis = "following robot [m]";
  chart.lines = {{"constraint curve", {}}, {"exchange of roles", {}, true, false}};
  for (const CurvePoint& point : work.curve.points)
    chart.lines[0].points.push_back({point.lead.q, point.follower.q});
  for (const RoleSwitch& s : work.work.switches) chart.lines[1].points.push_back({s.lead, s.follower});
  const double first = work.task.follower, last = work.task.path.length();
  for (std::size_t i = 0; i + 1 < work.task.path.size(); ++i) {
    const double end = work.task.path.to(i);
    chart.lines.push_back({"", {{first, end}, {last, end}}, false, true, true, 7});
    chart.lines.push_back({"", {{end, first}, {end, last}}, false, true, true, 7});
  }
  return {"constraint-curve", chart};
}

ReportChart forceChart(const std::vector<RealRun>& runs) {
  LineChart chart;
  chart.title = "Force of a joint on the rod";
  chart.caption = "The larger one of both ends, largest within each half second. Rod of 1 kg.";
  chart.x_axis = "time [s]";
  chart.y_axis = "force [N]";
  constexpr std::size_t kTicks = 30;
  for (const RealRun& run : runs) {
    if (run.name != "speed profile") continue;
    ChartLine line{fmt::format("{:.0f} cm/s", cm(run.pace)), {}};
    const std::vector<RodFrame>& frames = run.drive.frames;
    for (std::size_t i = 0; i < frames.size(); i += kTicks) {
      const auto end = frames.begin() + static_cast<std::ptrdiff_t>(std::min(i + kTicks, frames.size()));
      const auto largest = std::max_element(frames.begin() + static_cast<std::ptrdiff_t>(i), end,
                                            [](const auto& a, const auto& b) { return a.force < b.force; });
      line.points.push_back({countOf(i) / 60.0, largest->force});
    }
    chart.lines.push_back(std::move(line));
  }
  return {"rod-force", chart};
}

}  // namespace fulbito
