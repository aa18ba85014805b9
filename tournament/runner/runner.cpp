#include "tournament/runner/runner.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "engine/core/system/machine_room.hpp"
#include "engine/core/system/worker_threads.hpp"
#include "match/config/check_match.hpp"
#include "tournament/runner/course.hpp"
#include "tournament/runner/play_match.hpp"
#include "tournament/store/match_cache.hpp"
#include "tournament/store/match_line.hpp"

namespace fulbito {
namespace {

constexpr int kMostJobs = 1024;

int coreCount() { return threadsFor(0, kMostJobs); }

bool late(const MatchResult& result) {
  return result.faults.teams[0].late > 0 || result.faults.teams[1].late > 0;
}

TournamentState identified(TournamentState state, const MatchIdentity& identity) {
  for (const Fixture& fixture : state.schedule.fixtures) {
    state.ids.push_back({identity.of(fixture, 0), identity.of(fixture, 1)});
  }
  return state;
}

/// A match to play, or to play a second time and compare.
struct Task {
  std::size_t fixture = 0;
  std::size_t leg = 0;
  bool again = false;
};

/// The state of one call of `runTournament`, shared by its threads.
class Run {
 public:
  Run(const TournamentPlan& plan, const MatchIdentity& identity, const RunnerOptions& options)
      : plan_(plan), identity_(identity), options_(options), room_(options.retries), course_(plan) {}

  Result<RunOutcome> all();

 private:
  Result<void> lookUp();
  Result<std::optional<MatchRow>> found(const Fixture& fixture, const MatchId& id);
  std::vector<Task> tasks() const;
  Result<void> playAll(const std::vector<Task>& tasks);
  Result<void> play(const Task& task, WorkProgress& progress);
  Result<MatchResult> once(const Task& task, const MatchConfig& config, const std::function<bool()>& goes_on);
  Result<MatchResult> attempt(const Task& task, const std::function<bool()>& goes_on);
  Result<void> keep(const Task& task, const MatchResult& result);
  Result<void> leaveOut(const Task& task, const Error& error);
  std::vector<UnplayedMatch> unplayed() const;
  Result<void> playAgain(const Task& task, const std::function<bool()>& goes_on);
  Mismatch mismatchOf(const Task& task, const MatchRow& row) const;
  bool crowded(const MatchConfig& config) const;
  bool sampled(const MatchId& id) const;
  bool repeatable(const Fixture& fixture) const;
  bool decided();
  RunProgress progress();

  const Fixture& fixtureOf(const Task& task) const { return course_.fixtures()[task.fixture]; }
  MatchId idOf(const Task& task) const { return identity_.of(fixtureOf(task), task.leg); }
  MatchRow rowOf(const Task& task, const MatchResult& result) const;

  const TournamentPlan& plan_;
  const MatchIdentity& identity_;
  const RunnerOptions& options_;
  Turns turns_{coreCount()};
  MachineRoom room_;
  std::size_t looked_up_ = 0;   // number of fixtures looked up in log and cache
  std::vector<Task> compared_;  // matches from log or cache to play a second time
  std::mutex mutex_;            // guards all members below
  Course course_;
  RunOutcome outcome_;
  RunProgress progress_;
  // Reasons for matches left out, by fixture and leg.
  std::map<std::pair<std::size_t, std::size_t>, std::string> left_out_;
};

bool Run::sampled(const MatchId& id) const {
  return std::ldexp(static_cast<double>(id.words[0] >> 11), -53) < options_.verify;
}

bool Run::repeatable(const Fixture& fixture) const {
  const TeamIdentity &a = identity_.teams()[fixture.a], &b = identity_.teams()[fixture.b];
  return a.deterministic && a.repeats && b.deterministic && b.repeats;
}

MatchRow Run::rowOf(const Task& task, const MatchResult& result) const {
  const Fixture& fixture = fixtureOf(task);
  MatchRow row{idOf(task),
               {plan_.entrants[fixture.a].name, plan_.entrants[fixture.b].name},
               bookEntry(plan_.book, fixture.start).name,
               seedOfStart(plan_.seed, fixture.start),
               result};
  if (task.leg == 1) std::swap(row.teams[0], row.teams[1]);
  return row;
}

Result<std::optional<MatchRow>> Run::found(const Fixture& fixture, const MatchId& id) {
  if (auto row = options_.log->find(id)) return row;
  if (options_.cache == nullptr || !repeatable(fixture)) return std::optional<MatchRow>();
  auto row = options_.cache->find(id);
  if (row) {
    if (auto added = options_.log->add(*row); !added) return tl::unexpected<Error>(added.error());
  }
  return row;
}

Result<void> Run::lookUp() {
  for (; looked_up_ < course_.fixtures().size(); ++looked_up_) {
    if (options_.shard.has(looked_up_)) progress_.known += 2;
    for (std::size_t leg = 0; leg < 2; ++leg) {
      const Task task{looked_up_, leg, true};
      auto row = found(fixtureOf(task), idOf(task));
      if (!row) return tl::unexpected<Error>(row.error());
      if (!*row) continue;
      if (options_.shard.has(looked_up_)) {
        ++outcome_.taken;
        ++progress_.done;
        if (sampled(idOf(task)) && !late((*row)->result)) compared_.push_back(task);
      }
      course_.take(looked_up_, leg, std::move((*row)->result));
    }
  }
  return {};
}

std::vector<Task> Run::tasks() const {
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < course_.fixtures().size() && !course_.decided(); ++i) {
    if (!options_.shard.has(i)) continue;
    for (std::size_t leg = 0; leg < 2; ++leg) {
      if (course_.result(i, leg) == nullptr) tasks.push_back({i, leg, false});
    }
  }
  return tasks;
}

bool Run::decided() {
  const std::lock_guard lock(mutex_);
  return course_.decided();
}

RunProgress Run::progress() {
  const std::lock_guard lock(mutex_);
  progress_.sprt = course_.sprt();
  return progress_;
}

Result<MatchResult> Run::once(const Task& task, const MatchConfig& config,
                              const std::function<bool()>& goes_on) {
  Turns* const turns = crowded(config) ? &turns_ : nullptr;
  if (task.again || !options_.watch) return playMatch(config, options_.clock, goes_on, nullptr, turns);
  const auto watch = options_.watch(config, idOf(task));
  if (!watch) return tl::unexpected<Error>(watch.error());
  auto result = playMatch(config, options_.clock, goes_on, watch->observer.get(), turns);
  if (!result) return result;
  if (auto finished = watch->finish(); !finished) return tl::unexpected<Error>(finished.error());
  return result;
}

/// Whether other matches running at once could make a team outside the program late.
bool Run::crowded(const MatchConfig& config) const {
  return hasOutsideTeam(config) && options_.jobs > coreCount();
}

// A match that the machine failed has no result; it is played again.
Result<MatchResult> Run::attempt(const Task& task, const std::function<bool()>& goes_on) {
  const auto config = matchOf(plan_, fixtureOf(task), task.leg);
  if (!config) return tl::unexpected<Error>(config.error());
  for (int attempt = 0;; ++attempt) {
    auto result = room_.run([&] { return once(task, *config, goes_on); });
    if (result || result.error().code != ErrorCode::kIo || attempt >= options_.retries) return result;
    const std::lock_guard lock(mutex_);
    ++outcome_.retried;
  }
}

Result<void> Run::keep(const Task& task, const MatchResult& result) {
  // Rows are compared in the form in which reports read them from the log.
  const MatchRow row = storedForm(rowOf(task, result));
  auto added = options_.log->add(row);
  if (!added) return tl::unexpected<Error>(added.error());
  if (options_.cache != nullptr && repeatable(fixtureOf(task)) && !late(result)) {
    auto shared = options_.cache->add(row);
    if (!shared) return tl::unexpected<Error>(shared.error());
    if (*shared == Added::kDifferent) added = shared;
  }
  const std::lock_guard lock(mutex_);
  if (*added == Added::kDifferent) outcome_.mismatches.push_back(mismatchOf(task, row));
  ++outcome_.played;
  ++progress_.done;
  if (result.outcome >= MatchOutcome::kCrash) ++progress_.failures;
  left_out_.erase({task.fixture, task.leg});
  course_.take(task.fixture, task.leg, row.result);
  return {};
}

/// Records a match without a result. A sequential test then ends, because it needs all results in order.
Result<void> Run::leaveOut(const Task& task, const Error& error) {
  const std::lock_guard lock(mutex_);
  left_out_[{task.fixture, task.leg}] = error.message;
  return plan_.sprt ? fail(ErrorCode::kInterrupted, "a match is missing") : Result<void>();
}

std::vector<UnplayedMatch> Run::unplayed() const {
  std::vector<UnplayedMatch> unplayed;
  if (course_.decided()) return unplayed;  // all matches before the verdict have been played
  for (const auto& [match, reason] : left_out_) unplayed.push_back({match.first, match.second, reason});
  return unplayed;
}

/// Describes a match for which another run has meanwhile stored a different result.
Mismatch Run::mismatchOf(const Task& task, const MatchRow& row) const {
  auto first = options_.log->find(row.id);
  if (options_.cache != nullptr && (!first || sameResult(first->result, row.result))) {
    first = options_.cache->find(row.id);
  }
  return {fixtureOf(task), task.leg, first ? first->result : MatchResult{}, row.result};
}

Result<void> Run::playAgain(const Task& task, const std::function<bool()>& goes_on) {
  auto second = attempt({task.fixture, task.leg, true}, goes_on);
  if (!second && second.error().code == ErrorCode::kMachine) return {};  // there is nothing to compare
  if (!second) return tl::unexpected<Error>(second.error());
  const std::lock_guard lock(mutex_);
  const MatchResult& first = *course_.result(task.fixture, task.leg);
  ++outcome_.verified;
  if (!sameResult(first, *second)) {
    outcome_.mismatches.push_back({fixtureOf(task), task.leg, first, std::move(*second)});
  }
  return {};
}

Result<void> Run::play(const Task& task, WorkProgress& progress) {
  if (task.again) return playAgain(task, [&] { return progress.goesOn(); });
  const auto goes_on = [&] { return !decided() && progress.goesOn(); };
  if (decided()) return fail(ErrorCode::kInterrupted, "decided");
  auto result = attempt(task, goes_on);
  if (!result && result.error().code == ErrorCode::kMachine) return leaveOut(task, result.error());
  if (!result) return tl::unexpected<Error>(result.error());
  if (auto kept = keep(task, *result); !kept) return kept;
  if (sampled(idOf(task)) && !late(*result)) {
    if (auto again = playAgain(task, [&] { return progress.goesOn(); }); !again) return again;
  }
  return decided() ? fail(ErrorCode::kInterrupted, "decided") : Result<void>();
}

Result<void> Run::playAll(const std::vector<Task>& tasks) {
  WorkProgress watcher(
      [this](std::size_t, std::size_t) { return !options_.progress || options_.progress(progress()); },
      tasks.size());
  auto played = parallelFor(options_.jobs, tasks.size(), watcher,
                            [&](std::size_t i) { return play(tasks[i], watcher); });
  if (!played && played.error().code == ErrorCode::kInterrupted) {
    outcome_.interrupted = watcher.stopped();
    return {};
  }
  return played;
}

Result<RunOutcome> Run::all() {
  do {
    if (auto done = lookUp(); !done) return tl::unexpected<Error>(done.error());
    const std::vector<Task> missing = tasks();
    if (missing.empty()) continue;
    if (auto done = playAll(missing); !done) return tl::unexpected<Error>(done.error());
  } while (!outcome_.interrupted && !course_.decided() && course_.extend());
  if (!outcome_.interrupted && !compared_.empty()) {
    if (auto done = playAll(compared_); !done) return tl::unexpected<Error>(done.error());
  }
  std::vector<UnplayedMatch> left_out = unplayed();
  outcome_.state = identified(std::move(course_).state(), identity_);
  outcome_.state.unplayed = std::move(left_out);
  outcome_.retried += room_.repeated();
  return std::move(outcome_);
}

}  // namespace

Result<MatchConfig> matchOf(const TournamentPlan& plan, const Fixture& fixture, std::size_t leg) {
  MatchConfig config = plan.match;
  const std::array<std::size_t, 2> seats =
      leg == 0 ? std::array{fixture.a, fixture.b} : std::array{fixture.b, fixture.a};
  for (std::size_t seat = 0; seat < seats.size(); ++seat) {
    config.teams[seat] = plan.entrants[seats[seat]].team;
    config.vision[seat] = plan.match.vision[seats[seat] == 0 ? 0 : 1];
  }
  config.seed = seedOfStart(plan.seed, fixture.start);
  if (auto started = applyStart(plan.book, fixture.start, config); !started) {
    return tl::unexpected<Error>(started.error());
  }
  return config;
}

Result<void> checkPlan(const TournamentPlan& plan) {
  for (const auto& checked : {validate(plan), validateFormat(plan), validate(plan.book)}) {
    if (!checked) return checked;
  }
  const auto first = matchOf(plan, {0, 1, 0, 0}, 0);
  if (!first) return tl::unexpected<Error>(first.error());
  return checkMatch(*first);
}

Result<RunOutcome> runTournament(const TournamentPlan& plan, const MatchIdentity& identity,
                                 const RunnerOptions& options) {
  if (options.jobs < 0 || options.jobs > kMostJobs) {
    return fail(ErrorCode::kUsage, fmt::format("jobs: {} is outside 0 ... {}", options.jobs, kMostJobs));
  }
  if (auto checked = checkPlan(plan); !checked) return tl::unexpected<Error>(checked.error());
  return Run(plan, identity, options).all();
}

TournamentState stateOf(const TournamentPlan& plan, const MatchIdentity& identity, const MatchStore& log) {
  Course course(plan);
  std::size_t next = 0;
  do {
    for (; next < course.fixtures().size(); ++next) {
      for (std::size_t leg = 0; leg < 2; ++leg) {
        if (auto row = log.find(identity.of(course.fixtures()[next], leg))) {
          course.take(next, leg, std::move(row->result));
        }
      }
    }
  } while (course.extend());
  return identified(std::move(course).state(), identity);
}

}  // namespace fulbito
