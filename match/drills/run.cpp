#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "engine/core/system/worker_threads.hpp"
#include "match/drills/trials.hpp"

namespace fulbito {
namespace {

int trialsOf(const DrillOptions& options, const Drill& drill) {
  return options.trials > 0 ? options.trials : drill.trials;
}

Result<std::vector<DrillTrial>> playTrials(const DrillRun& run, const Drill& drill, WorkProgress& progress) {
  const auto base = drillMatch(run, drill);
  if (!base) return tl::unexpected<Error>(base.error());
  std::vector<DrillTrial> trials(static_cast<std::size_t>(trialsOf(run.options, drill)));
  const auto played =
      parallelFor(run.options.jobs, trials.size(), progress, [&](std::size_t i) -> Result<void> {
        auto trial = run.room.run([&] { return playTrial(run, drill, *base, static_cast<int>(i)); });
        if (!trial) return tl::unexpected<Error>(trial.error());
        trials[i] = *trial;
        return {};
      });
  if (!played) return tl::unexpected<Error>(played.error());
  return trials;
}

const Drill* findDrill(const std::vector<Drill>& drills, int number) {
  const auto found =
      std::find_if(drills.begin(), drills.end(), [&](const Drill& d) { return d.number == number; });
  return found == drills.end() ? nullptr : &*found;
}

void addValues(DrillReport& report, const std::vector<DrillTrial>& trials) {
  constexpr double kDoesNotCount = std::numeric_limits<double>::quiet_NaN();
  for (const DrillTrial& trial : trials) {
    report.values.push_back(!trial.counted ? kDoesNotCount : trial.success ? 1.0 : 0.0);
  }
}

Result<void> runTrials(const DrillRun& run, DrillReport& report, WorkProgress& progress) {
  auto trials = playTrials(run, report.drill, progress);
  if (!trials) return tl::unexpected<Error>(trials.error());
  report.trials = std::move(*trials);
  addValues(report, report.trials);
  report.offered = std::all_of(report.trials.begin(), report.trials.end(),
                               [](const DrillTrial& trial) { return trial.offered; });
  report.verdicts = judgeTrials(report.drill, report.trials);
  return {};
}

Result<void> runMatches(const DrillRun& run, DrillReport& report, WorkProgress& progress) {
  const auto base = drillMatch(run, report.drill);
  if (!base) return tl::unexpected<Error>(base.error());
  std::vector<DrillMatch> matches(static_cast<std::size_t>(trialsOf(run.options, report.drill)));
  const auto played =
      parallelFor(run.options.jobs, matches.size(), progress, [&](std::size_t i) -> Result<void> {
        auto match =
            run.room.run([&] { return playDrillMatch(run, report.drill, *base, static_cast<int>(i)); });
        if (!match) return tl::unexpected<Error>(match.error());
        matches[i] = *match;
        return {};
      });
  if (!played) return tl::unexpected<Error>(played.error());
  const bool roles = std::any_of(report.drill.bars.begin(), report.drill.bars.end(), [](const DrillBar& bar) {
    return bar.value == DrillMeasure::kSwitch || bar.value == DrillMeasure::kFlap;
  });
  report.offered = !roles || std::all_of(matches.begin(), matches.end(),
                                         [](const DrillMatch& match) { return match.roles_told; });
  report.verdicts = judgeMatches(report.drill, matches);
  for (const DrillMatch& match : matches) report.values.push_back(marginOf(match));
  return {};
}

int successes(const std::vector<DrillTrial>& trials) {
  return static_cast<int>(
      std::count_if(trials.begin(), trials.end(), [](const DrillTrial& trial) { return trial.success; }));
}

/// Runs each repeated drill twice, under better and under worse sight, with the same starts.
Result<void> runRepeats(const DrillRun& run, const std::vector<Drill>& drills, DrillReport& report,
                        WorkProgress& progress) {
  const Drill& asked = report.drill;
  const double dt = run.physics.controlPeriod();
  for (const int number : asked.repeats) {
    Drill repeated = *findDrill(drills, number);
    repeated.trials = asked.trials;
    repeated.sight = asked.sight_before;
    const auto before = playTrials(run, repeated, progress);
    if (!before) return tl::unexpected<Error>(before.error());
    repeated.sight = asked.sight;
    repeated.latency += (asked.sight.latency_ticks - asked.sight_before.latency_ticks) * dt;
    const auto after = playTrials(run, repeated, progress);
    if (!after) return tl::unexpected<Error>(after.error());
    addValues(report, *after);
    const double reference = static_cast<double>(successes(*before)) / static_cast<double>(before->size());
    Interval kept = wilson(successes(*after), static_cast<int>(after->size()));
    if (reference > 0.0) kept = {kept.value / reference, kept.low / reference, kept.high / reference};
    for (const DrillBar& bar : asked.bars) {
      DrillVerdict verdict;
      verdict.bar = bar;
      verdict.bar.start = fmt::format("drill {}", number);
      verdict.count = static_cast<int>(after->size());
      verdict.value = kept;
      judge(verdict);
      verdict.passed = verdict.passed && reference > 0.0;
      report.verdicts.push_back(std::move(verdict));
    }
  }
  return {};
}

Result<void> checkRepeats(const std::vector<Drill>& drills, const Drill& drill) {
  for (const int number : drill.repeats) {
    const Drill* repeated = findDrill(drills, number);
    if (repeated == nullptr || repeated->starts.empty()) {
      return fail(ErrorCode::kBadInput,
                  fmt::format("{}: drill.repeats: there are no trials of a drill {}", drill.file, number));
    }
  }
  return {};
}

std::size_t workOf(const DrillOptions& options, const Drill& drill) {
  const auto trials = static_cast<std::size_t>(trialsOf(options, drill));
  return drill.repeats.empty() ? trials : 2 * drill.repeats.size() * trials;
}

}  // namespace

bool DrillReport::passed() const {
  return offered && !verdicts.empty() &&
         std::all_of(verdicts.begin(), verdicts.end(), [](const DrillVerdict& v) { return v.passed; });
}

Result<std::vector<DrillReport>> runDrills(const std::vector<Drill>& drills, const std::vector<int>& numbers,
                                           const DrillOptions& options, const DrillProgress& watcher) {
  DrillRun run{options, {}, {}};
  auto robot = loadRobot(options.robot);
  if (!robot) return tl::unexpected<Error>(robot.error());
  run.robot = std::move(*robot);
  auto physics = loadPhysics(options.physics);
  if (!physics) return tl::unexpected<Error>(physics.error());
  run.physics = std::move(*physics);
  std::vector<const Drill*> asked;
  std::size_t total = 0;
  for (const Drill& drill : drills) {
    if (!numbers.empty() && std::find(numbers.begin(), numbers.end(), drill.number) == numbers.end())
      continue;
    if (auto checked = checkRepeats(drills, drill); !checked) return tl::unexpected<Error>(checked.error());
    asked.push_back(&drill);
    total += workOf(options, drill);
  }
  WorkProgress progress(watcher, total);
  std::vector<DrillReport> reports;
  for (const Drill* drill : asked) {
    DrillReport report;
    report.drill = *drill;
    Result<void> ran;
    if (!drill->repeats.empty()) {
      ran = runRepeats(run, drills, report, progress);
    } else if (!drill->match_opponent.empty()) {
      ran = runMatches(run, report, progress);
    } else {
      ran = runTrials(run, report, progress);
    }
    if (!ran) return tl::unexpected<Error>(ran.error());
    reports.push_back(std::move(report));
  }
  return reports;
}

}  // namespace fulbito
