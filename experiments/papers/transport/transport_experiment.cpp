#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "experiments/papers/transport/path_file.hpp"
#include "experiments/papers/transport/transport_report.hpp"
#include "experiments/papers/transport/transport_work.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kRandomPaths = 40;
constexpr double kMillimetres = 1000.0;  // per metre
constexpr double kCentimetres = 100.0;
constexpr std::size_t kShownPace = 1;  // index of 0.2 m/s in the list of paces
constexpr double kShownEvery = 12.0;   // [s] between the drawn places on the long path

template <typename List, typename Test>
double countIf(const List& list, Test test) {
  return static_cast<double>(std::count_if(list.begin(), list.end(), test));
}

/// All results of a full run.
struct Everything {
  PathWork s_path;
  TransportTask maze;
  Carrying maze_work;
  std::vector<PrintedRun> maze_printed;
  Carrying fine;  ///< the S path with a step of 2 ms
  std::vector<RandomRun> random;
};

// The largest distance [m] of an exchange of roles from its place with very small steps.
double switchShift(const Carrying& work, const Carrying& fine) {
  if (work.switches.size() != fine.switches.size()) return std::nan("");
  double largest = 0.0;
  for (std::size_t i = 0; i < work.switches.size(); ++i) {
    const RoleSwitch &a = work.switches[i], &b = fine.switches[i];
    largest = std::max({largest, std::abs(a.lead - b.lead), std::abs(a.follower - b.follower)});
  }
  return largest;
}

PaperFigure figure(std::string id, std::string where, std::string what, std::string unit, int decimals) {
  PaperFigure f;
  f.id = std::move(id);
  f.where = std::move(where);
  f.what = std::move(what);
  f.unit = std::move(unit);
  f.decimals = decimals;
  return f;
}

void addBound(std::vector<PaperFigure>& figures, PaperFigure f, double ours, double high,
              std::optional<double> paper = {}, std::string reason = {}) {
  f.ours = ours;
  f.high = high;
  f.paper = paper;
  f.reason = std::move(reason);
  figures.push_back(std::move(f));
}

void addExact(std::vector<PaperFigure>& figures, PaperFigure f, double ours, double wanted,
              std::optional<double> paper = {}, std::string reason = {}) {
  f.low = wanted;
  addBound(figures, std::move(f), ours, wanted, paper, std::move(reason));
}

void addPlain(std::vector<PaperFigure>& figures, PaperFigure f, double ours, std::string reason) {
  f.ours = ours;
  f.reason = std::move(reason);
  figures.push_back(std::move(f));
}

double peakOf(const Everything& all) {
  double peak = std::max(all.s_path.work.peak_speed, all.maze_work.peak_speed);
  for (const RandomRun& run : all.random) peak = std::max(peak, run.work.peak_speed);
  for (const StepErrors& e : all.s_path.steps) peak = std::max(peak, e.projected.peak_speed);
  for (const RadioRun& run : all.s_path.radios) peak = std::max(peak, run.work.peak_speed);
  return peak;
}

double worstRadio(const PathWork& work) {
  double worst = 0.0;
  for (const RadioRun& run : work.radios) worst = std::max(worst, run.work.rod_error);
  return worst;
}

/// Adds the farthest run of the printed rules on the long path.
void addPrinted(std::vector<PaperFigure>& figures, const Everything& all) {
  double arrived = 0.0;
  const PrintedRun* best = &all.maze_printed.front();
  for (const PrintedRun& run : all.maze_printed) {
    if (run.work.end == StopReason::kArrived) arrived += 1.0;
    if (run.work.lead > best->work.lead) best = &run;
  }
  const auto runs = static_cast<double>(all.maze_printed.size());
  addExact(figures,
           figure("maze-printed", "Fig. 10",
                  fmt::format("runs to its end by the printed rules, of {:g}", runs), "", 0),
           arrived, runs, runs,
           "a slave that would leave its part and one that would be too fast hand the role to and fro");
  addPlain(figures,
           figure("maze-printed-lead", "Fig. 10", "farthest place of the lead by the printed rules", "m", 2),
           best->work.lead,
           fmt::format("of {:.2f} m; {} after {:.0f} s and {} exchanges", all.maze.path.length(),
                       best->work.end == StopReason::kDeadlock ? "deadlock" : "end", best->work.seconds,
                       best->work.switches.size()));
}

void addPathFigures(std::vector<PaperFigure>& figures, const Everything& all) {
  const PathWork& s = all.s_path;
  addExact(figures, figure("switches", "Fig. 9", "exchanges of roles on the S path", "", 0),
           static_cast<double>(s.work.switches.size()), 7, 7.0);
  addBound(figures,
           figure("switch-shift", "Fig. 9", "largest shift of an exchange against steps of 2 ms", "cm", 2),
           switchShift(s.work, all.fine) * kCentimetres, 1.0);
  addBound(figures, figure("rod-error", "section IV.3", "largest error of the rod's length, S path", "mm", 3),
           s.work.rod_error * kMillimetres, 1.0);
  addExact(figures, figure("maze-parts", "Fig. 10", "parts of the long path", "", 0),
           static_cast<double>(all.maze.path.size()), 43, 43.0,
           "the paper prints no table of it: a path of ours in the same area");
  addPrinted(figures, all);
  addExact(figures, figure("maze-arrives", "Fig. 10", "runs to its end, ours", "", 0),
           all.maze_work.end == StopReason::kArrived ? 1 : 0, 1, 1.0,
           "a master that slows down in an impasse, which the paper does not have");
  addPlain(figures, figure("maze-exchanges", "Fig. 10", "exchanges of roles, ours", "", 0),
           static_cast<double>(all.maze_work.switches.size()), "the paper gives no number");
  addBound(figures, figure("maze-rod-error", "Fig. 10", "largest error of the rod's length", "mm", 3),
           all.maze_work.rod_error * kMillimetres, 1.0);
  addBound(figures, figure("peak-speed", "section IV.2", "highest speed in all runs", "cm/s", 3),
           peakOf(all) * kCentimetres, 10.0, 10.0);
}

void addOtherFigures(std::vector<PaperFigure>& figures, const Everything& all) {
  const PathWork& s = all.s_path;
  const auto total = static_cast<double>(kRandomPaths);
  addExact(figures, figure("random-right", "-", "random paths completed or correctly refused, of 40", "", 0),
           countIf(all.random, [](const RandomRun& r) { return r.right(); }), total);
  addPlain(figures, figure("random-refused", "-", "of them refused", "", 0),
           countIf(all.random, [](const RandomRun& r) { return !r.accepted(); }), "");
  addPlain(figures,
           figure("random-printed", "section III.3", "of them that the printed algorithm completes", "", 0),
           countIf(all.random, [](const RandomRun& r) { return r.printed.end == StopReason::kArrived; }),
           "a slave that would leave its part and one that would be too fast hand the role to and fro");
  addExact(
      figures,
      figure("radio-arrives", "-", "radios with loss, delay or silence over which they arrive, of 8", "", 0),
      countIf(s.radios, [](const RadioRun& r) { return r.work.end == StopReason::kArrived; }),
      static_cast<double>(s.radios.size()));
  addBound(figures, figure("radio-rod-error", "-", "largest error of the rod's length over these", "mm", 3),
           worstRadio(s) * kMillimetres, 1.0);
  addBound(
      figures,
      figure("real-centre-speed", "section IV.2", "real rod at 10 cm/s: highest speed of a robot's centre",
             "cm/s", 2),
      s.real.front().drive.peak_speed * kCentimetres, 10.0, 10.0,
      "the limit is of the reference; a robot that lags behind it catches up at 4 per second of the lag");
  const RodDrive& drive = s.real[kShownPace].drive;
  addPlain(figures, figure("real-force", "-", "real rod at 20 cm/s: largest force", "N", 2), drive.peak_force,
           "");
  addPlain(figures,
           figure("real-path-error", "-", "real rod at 20 cm/s: largest distance from the path", "mm", 2),
           drive.path_error * kMillimetres, "");
}

void addPathReport(ExperimentReport& report, const PathWork& work, const std::string& chart) {
  report.tables.push_back(partTable(work.task));
  report.tables.push_back(switchTable(work.work));
  report.tables.push_back(phaseTable(work.work));
  report.tables.push_back(stepTable(work.steps));
  report.tables.push_back(radioTable(work.radios));
  report.charts.push_back(speedChart(chart, work.task, work.work));
  report.charts.push_back(curveChart(work));
  report.charts.push_back(stepChart(work.steps));
  if (work.real.empty()) {
    report.notes.push_back("No real rod: " + work.why_not_real + ", where no wheeled robot keeps on.");
    return;
  }
  report.tables.push_back(realTable(work.real));
  report.charts.push_back(forceChart(work.real));
}

ExperimentReport newReport() {
  ExperimentReport report;
  report.name = "transport";
  report.title = "Lee, Lee & Lee: two robots that carry a rod";
  return report;
}

Result<ExperimentReport> runFile(const TransportSettings& settings, const ExperimentRequest& request) {
  const auto task = loadTransport(settings.path);
  if (!task) return tl::unexpected<Error>(task.error());
  const auto work = workOn(*task, settings, request);
  if (!work) {
    if (work.error().code != ErrorCode::kBadInput) return tl::unexpected<Error>(work.error());
    return fail(ErrorCode::kBadInput, settings.path + ": " + work.error().message);
  }
  ExperimentReport report = newReport();
  addPathReport(report, *work, "speeds");
  report.scenes.push_back(planScene("path", "Path", *task, work->work));
  if (!work->real.empty()) report.scenes.push_back(realScene("real-rod", *work, work->real[kShownPace]));
  return report;
}

Result<Everything> runPaper(const TransportSettings& settings, const ExperimentRequest& request) {
  Everything all;
  auto s_path = workOn(builtInTransport("s-path"), settings, request);
  if (!s_path) return tl::unexpected<Error>(s_path.error());
  all.s_path = std::move(*s_path);
  CarryPlan fine;
  fine.step = 0.002;
  all.fine = carry(all.s_path.task, fine);
  all.maze = builtInTransport("maze");
  all.maze_work = carry(all.maze, settings.plan);
  auto printed = printedRuns(all.maze, request);
  if (!printed) return tl::unexpected<Error>(printed.error());
  all.maze_printed = std::move(*printed);
  auto random = randomRuns(request, kRandomPaths);
  if (!random) return tl::unexpected<Error>(random.error());
  all.random = std::move(*random);
  return all;
}

Result<ExperimentReport> run(const ExperimentRequest& request) {
  const auto settings = transportSettings(request);
  if (!settings) return tl::unexpected<Error>(settings.error());
  if (!settings->path.empty()) return runFile(*settings, request);
  const auto all = runPaper(*settings, request);
  if (!all) return tl::unexpected<Error>(all.error());
  ExperimentReport report = newReport();
  addPathFigures(report.figures, *all);
  addOtherFigures(report.figures, *all);
  addPathReport(report, all->s_path, "fig-9");
  report.tables.push_back(printedTable(all->maze, all->maze_printed, all->maze_work, settings->plan.step));
  report.tables.push_back(randomTable(all->random));
  report.tables.push_back(fitTable());
  report.charts.push_back(speedChart("fig-10-speeds", all->maze, all->maze_work));
  report.scenes.push_back(planScene("s-path", "S path", all->s_path.task, all->s_path.work));
  showSteps(all->s_path.work, report.scenes.back());
  report.scenes.push_back(planScene("fig-10", "As Fig. 10", all->maze, all->maze_work));
  showEvery(kShownEvery, report.scenes.back());
  report.scenes.push_back(realScene("real-rod", all->s_path, all->s_path.real[kShownPace]));
  for (ReportScene& scene : report.scenes) scene.page.seed = request.seed;
  report.notes.push_back(
      "The tables of errors, radios and real rods do not depend on the settings step, loss and delay.");
  return report;
}

}  // namespace

namespace transport {

PaperExperiment experiment() {
  return {"transport", "two robots carry a rod along lines and arcs, by messages",
          "S. H. Lee, S. Lee and Y.-J. Lee: Cooperative Motion Planning of Two Tightly-Coupled Mobile Robots",
          transportSettingList(), run};
}

}  // namespace transport

}  // namespace fulbito
