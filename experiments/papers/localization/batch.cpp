#include "experiments/papers/localization/batch.hpp"

#include <utility>

#include "experiments/papers/random/streams.hpp"

namespace fulbito::localization {
namespace {

constexpr std::uint64_t kExampleIndex = 2'000'000;  // different from the indices of all other runs

CleaningTask exampleTask(std::uint64_t seed, const SensorSpread& spread) {
  CleaningTask task;
  Rng draws(seed, kRoomStream, kExampleIndex);
  task.field = plainRoom({3.4, 2.8});
  task.rover = withErrors(cleaningRobot(), spread, draws);
  task.spread = spread;
  task.start = {{2.1, 1.2}, 1.0};
  task.celsius = 28.0;
  task.seed = seed;
  task.index = kExampleIndex;
  return task;
}

std::vector<Ground> groundsOf(const BatchSize& size, std::uint64_t seed, Batch& batch) {
  RandomRooms rooms = randomRooms(size.rooms, seed, size.spread);
  batch.refused_rooms = std::move(rooms.refusals);
  const FieldGeometry field;
  std::vector<Ground> grounds;
  grounds.push_back({"random rooms", std::move(rooms.tasks), {}});
  for (const auto& [name, form] :
       {std::pair{"soccer field, goals boarded up", withoutGoals(field)},
        std::pair{"rectangle of 1.5 x 1.3 m", plainRoom({field.length, field.width})},
        std::pair{"soccer field, goals open", field}}) {
    grounds.push_back({name, fieldTasks(form, size.fields, seed, size.spread), {}});
  }
  return grounds;
}

/// One run with one scheme.
struct Job {
  Ground* ground;
  std::size_t scheme, task;
  bool with_moments;
};

void addJobs(Ground& ground, bool with_moments, std::vector<Job>& jobs) {
  for (std::size_t s = 0; s < kSchemes.size(); ++s) {
    ground.results[s].resize(ground.tasks.size());
    for (std::size_t t = 0; t < ground.tasks.size(); ++t) jobs.push_back({&ground, s, t, with_moments});
  }
}

Result<void> run(const Job& job) {
  auto result = runCleaning(job.ground->tasks[job.task], kSchemes[job.scheme], job.with_moments);
  if (!result) return tl::unexpected<Error>(result.error());
  job.ground->results[job.scheme][job.task] = std::move(*result);
  return {};
}

}  // namespace

Result<Batch> runBatch(const BatchSize& size, std::uint64_t seed, int jobs, const WorkWatcher& watcher) {
  Batch batch;
  batch.grounds = groundsOf(size, seed, batch);
  batch.example = {"example", {exampleTask(seed, size.spread)}, {}};
  batch.field_example = {"field example", fieldTasks(withoutGoals({}), 1, seed, size.spread), {}};
  std::vector<Job> work;
  for (Ground& ground : batch.grounds) addJobs(ground, false, work);
  addJobs(batch.example, true, work);
  addJobs(batch.field_example, true, work);
  WorkProgress progress(watcher, work.size());
  auto done = parallelFor(jobs, work.size(), progress, [&](std::size_t i) { return run(work[i]); });
  if (!done) return tl::unexpected<Error>(done.error());
  auto wrong = runWrongFigures(wrongCases(), size.wrong, seed, size.spread, jobs, watcher);
  if (!wrong) return tl::unexpected<Error>(wrong.error());
  batch.wrong = std::move(*wrong);
  return batch;
}

}  // namespace fulbito::localization
