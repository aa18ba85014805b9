#include "experiments/papers/transport/transport_work.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include <fmt/format.h>

#include "experiments/papers/transport/random_path.hpp"
#include "fulbito/report.hpp"

namespace fulbito {
namespace {

using Job = std::function<Result<void>()>;

Result<void> runAll(const ExperimentRequest& request, const std::vector<Job>& jobs) {
  WorkProgress progress(request.progress, jobs.size());
  return parallelFor(request.jobs, jobs.size(), progress, [&](std::size_t i) { return jobs[i](); });
}

constexpr double kSteps[] = {0.01, 0.02, 0.05,
                             0.1,  0.2,  0.5};     // [s] the first four are also in the paper's range
constexpr double kPaces[] = {0.1, 0.2, 0.3, 0.4};  // [m/s]
constexpr double kFastShare = 5.0;                 // factor of the paper's speeds, too fast for the wheels

void addStepJobs(PathWork& work, std::vector<Job>& jobs) {
  for (const double step : kSteps) work.steps.push_back({step, {}, {}});
  for (StepErrors& errors : work.steps) {
    const auto run = [&work, &errors](bool project) {
      CarryPlan plan;
      plan.step = errors.step;
      plan.habits.project = project;
      (project ? errors.projected : errors.euler) = carry(work.task, plan);
      return Result<void>{};
    };
    jobs.push_back([run] { return run(true); });
    jobs.push_back([run] { return run(false); });
  }
}

std::vector<RadioRun> radiosFor(double seconds) {
  const auto cut = [&](bool lead, bool follower) {
    RadioModel radio;
    for (const double share : {0.2, 0.5, 0.8})
      radio.outages.push_back({share * seconds, share * seconds + 3.0, lead, follower});
    return radio;
  };
  return {{"ideal", {0.0, 0.0, {}}, {}},
          {"5 % lost", {0.05, 0.0, {}}, {}},
          {"20 % lost", {0.20, 0.0, {}}, {}},
          {"up to 1 ms late", {0.0, 0.001, {}}, {}},
          {"10 % lost, up to 5 ms late", {0.10, 0.005, {}}, {}},
          {"silent three times for 3 s", cut(true, true), {}},
          {"the same, to the lead only", cut(true, false), {}},
          {"the same, to the follower only", cut(false, true), {}}};
}

void addRadioJobs(PathWork& work, std::uint64_t seed, std::vector<Job>& jobs) {
  work.radios = radiosFor(work.curve.points.back().along / work.task.speed);
  for (std::size_t i = 0; i < work.radios.size(); ++i) {
    jobs.push_back([&work, i, seed] {
      CarryPlan plan;
      plan.radio = work.radios[i].radio;
      plan.seed = seed;
      plan.index = 1000 + i;
      work.radios[i].work = carry(work.task, plan);
      return Result<void>{};
    });
  }
}

Result<void> driveProfile(const PathWork& work, RealRun& run) {
  RodPace pace;
  pace.speed = run.pace;
  const double tick = work.world.physics.controlPeriod();
  auto references = profileAlong(work.task, work.curve, work.world.robot, pace, tick);
  if (!references) return tl::unexpected<Error>(references.error());
  auto drive = driveRod(work.task, work.world, *references);
  if (!drive) return tl::unexpected<Error>(drive.error());
  run.drive = std::move(*drive);
  return {};
}

// The same motion in a shorter time.
Carrying faster(Carrying work, double share) {
  work.seconds /= share;
  for (CarryRow& row : work.rows) {
    row.time /= share;
    row.lead_speed *= share;
    row.follower_speed *= share;
  }
  return work;
}

// Drives the speeds of the messages directly, times `share`, without a speed profile.
Result<void> driveMessages(const PathWork& work, double share, RealRun& run) {
  CarryPlan plan;
  plan.keep_rows = true;
  const Carrying carried = faster(carry(work.task, plan), share);
  const auto references = referencesOf(work.task, carried, work.world.physics.controlPeriod());
  auto drive = driveRod(work.task, work.world, references);
  if (!drive) return tl::unexpected<Error>(drive.error());
  run.drive = std::move(*drive);
  return {};
}

void addRealJobs(PathWork& work, std::vector<Job>& jobs) {
  work.world = rodWorldFor(work.task);
  const auto possible = profileAlong(work.task, work.curve, work.world.robot, {}, 1.0);
  if (!possible) {
    work.why_not_real = possible.error().message;
    return;
  }
  for (const double pace : kPaces) work.real.push_back({"speed profile", pace, {}});
  work.real.push_back({"speeds of the messages", work.task.max_speed, {}});
  work.real.push_back({"the same, five times as fast", work.task.max_speed * kFastShare, {}});
  const std::size_t profiles = std::size(kPaces);
  for (std::size_t i = 0; i < profiles; ++i)
    jobs.push_back([&work, i] { return driveProfile(work, work.real[i]); });
  jobs.push_back([&work] { return driveMessages(work, 1.0, work.real[std::size(kPaces)]); });
  jobs.push_back([&work] { return driveMessages(work, kFastShare, work.real[std::size(kPaces) + 1]); });
}

RandomRun randomRun(std::uint64_t seed, std::uint64_t index) {
  constexpr double kCell = 0.002;  // [m]
  RandomRun run;
  run.task = randomTransport(seed, index);
  run.curve = traceCurve(run.task);
  run.curve.points.erase(run.curve.points.begin(), run.curve.points.end() - 1);
  run.contour = walkContour(run.task, kCell);
  CarryPlan plan;
  run.work = carry(run.task, plan);
  plan.habits.slow = false;
  run.printed = carry(run.task, plan);
  return run;
}

}  // namespace

bool RandomRun::right() const {
  constexpr double kSamePlace = 0.01;  // [m]
  const CurvePoint& last = curve.points.back();
  const bool agrees = curve.end == contour.end && std::abs(last.lead.q - contour.lead) < kSamePlace &&
                      std::abs(last.follower.q - contour.follower) < kSamePlace;
  return agrees && accepted() == (work.end == StopReason::kArrived);
}

namespace {

struct Numbers {
  double step = CarryPlan{}.step;  // [s]
  double loss = 0.0, delay = 0.0;  // share of messages, [s]
};

std::vector<Parameter<Numbers>> parameters() {
  return {number("step", &Numbers::step, 0.001, 1.0, "", "longest run between messages [s], 0.001 to 1"),
          number("loss", &Numbers::loss, 0.0, 0.5, "", "share of messages that get lost, 0 to 0.5"),
          number("delay", &Numbers::delay, 0.0, 0.1, "", "longest delay of a message [s], 0 to 0.1")};
}

}  // namespace

std::vector<ExperimentSetting> transportSettingList() {
  std::vector<ExperimentSetting> list = settingsOf(specsOf(parameters()));
  list.insert(list.begin(),
              {"path", "", "file of the path to carry along, in place of the paper's (docs/papers.md)"});
  return list;
}

Result<TransportSettings> transportSettings(const ExperimentRequest& request) {
  TransportSettings settings;
  settings.path = request.find("path").value_or("");
  std::vector<Setting> others = request.settings;
  std::erase_if(others, [](const Setting& setting) { return setting.name == "path"; });
  Numbers numbers;
  if (auto set = applySettings(parameters(), others, "transport", numbers); !set)
    return tl::unexpected<Error>(set.error());
  settings.plan.step = numbers.step;
  settings.plan.radio = {numbers.loss, numbers.delay, {}};
  settings.plan.seed = request.seed;
  settings.plan.keep_rows = true;
  return settings;
}

Result<PathWork> workOn(const TransportTask& task, const TransportSettings& settings,
                        const ExperimentRequest& request) {
  PathWork work;
  work.task = task;
  work.curve = traceCurve(task);
  if (!work.curve.arrives()) return fail(ErrorCode::kBadInput, refusal(task, work.curve));
  std::vector<Job> jobs;
  jobs.push_back([&] {
    work.work = carry(task, settings.plan);
    return Result<void>{};
  });
  addStepJobs(work, jobs);
  addRadioJobs(work, request.seed, jobs);
  addRealJobs(work, jobs);
  if (auto done = runAll(request, jobs); !done) return tl::unexpected<Error>(done.error());
  return work;
}

Result<std::vector<RandomRun>> randomRuns(const ExperimentRequest& request, std::size_t count) {
  std::vector<RandomRun> runs(count);
  WorkProgress progress(request.progress, count);
  auto done = parallelFor(request.jobs, count, progress, [&](std::size_t i) {
    runs[i] = randomRun(request.seed, i);
    return Result<void>{};
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return runs;
}

Result<std::vector<PrintedRun>> printedRuns(const TransportTask& task, const ExperimentRequest& request) {
  std::vector<PrintedRun> runs;
  for (const double step : {0.01, 0.05, 0.1}) {
    for (const bool project : {false, true}) runs.push_back({step, project, {}});
  }
  WorkProgress progress(request.progress, runs.size());
  auto done = parallelFor(request.jobs, runs.size(), progress, [&](std::size_t i) {
    CarryPlan plan;
    plan.step = runs[i].step;
    plan.habits = {runs[i].project, false};
    runs[i].work = carry(task, plan);
    return Result<void>{};
  });
  if (!done) return tl::unexpected<Error>(done.error());
  return runs;
}

std::vector<RodReference> referencesOf(const TransportTask& task, const Carrying& work, double tick) {
  std::vector<RodReference> references;
  const auto ticks = static_cast<std::size_t>(std::ceil(work.seconds / tick));
  for (std::size_t i = 0, row = 0; i <= ticks; ++i) {
    const double time = std::min(static_cast<double>(i) * tick, work.seconds);
    while (row + 1 < work.rows.size() && work.rows[row + 1].time <= time) ++row;
    const CarryRow& from = work.rows[row];
    const double since = time - from.time;
    references.push_back({{from.lead, from.lead_speed}, {from.follower, from.follower_speed}});
    references.back().lead.place.q = std::min(from.lead.q + from.lead_speed * since, task.path.length());
    references.back().follower.place.q = from.follower.q + from.follower_speed * since;
  }
  references.back().lead.speed = references.back().follower.speed = 0.0;
  return references;
}

}  // namespace fulbito
