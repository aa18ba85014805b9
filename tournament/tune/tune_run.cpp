#include "tournament/tune/tune_run.hpp"

#include <iterator>
#include <utility>

namespace fulbito {
namespace {

/// The state of one call of `runTune`.
class TuneRun {
 public:
  TuneRun(const TunePlan& plan, const TeamCatalogue& teams, const TuneOptions& options)
      : plan_(plan), teams_(teams), options_(options), point_(startOf(plan.spsa)) {}

  Result<TuneOutcome> all();

 private:
  Result<void> iterate();
  Result<void> judge();
  bool stopped() const { return outcome_.interrupted || !outcome_.unplayed.empty(); }
  /// Plays a plan. Empty if the run was stopped.
  Result<std::optional<TournamentState>> play(const TournamentPlan& plan);
  void count(RunOutcome& outcome);

  const TunePlan& plan_;
  const TeamCatalogue& teams_;
  const TuneOptions& options_;
  TunePoint point_;
  std::size_t done_ = 0;  // matches with results
  TuneOutcome outcome_;
};

void TuneRun::count(RunOutcome& outcome) {
  outcome_.played += outcome.played;
  outcome_.taken += outcome.taken;
  std::move(outcome.mismatches.begin(), outcome.mismatches.end(), std::back_inserter(outcome_.mismatches));
  outcome_.failures += failedMatches(outcome.state);
  done_ += outcome.played + outcome.taken;
}

Result<std::optional<TournamentState>> TuneRun::play(const TournamentPlan& plan) {
  const auto identity = MatchIdentity::create(plan);
  if (!identity) return tl::unexpected<Error>(identity.error());
  RunnerOptions run;
  run.jobs = options_.jobs;
  run.clock = options_.clock;
  run.log = options_.log;
  run.progress = [this](const RunProgress& part) {
    RunProgress whole = part;
    whole.done += done_;
    whole.known = matchesOf(plan_);
    whole.failures += outcome_.failures;
    return !options_.progress || options_.progress(whole);
  };
  auto outcome = runTournament(plan, *identity, run);
  if (!outcome) return tl::unexpected<Error>(outcome.error());
  count(*outcome);
  outcome_.interrupted = outcome->interrupted;
  outcome_.unplayed = outcome->state.unplayed;
  if (stopped()) return std::optional<TournamentState>();
  return std::optional(std::move(outcome->state));
}

Result<void> TuneRun::iterate() {
  const int iteration = static_cast<int>(outcome_.results.size()) + 1;
  const auto own = iterationPlan(plan_, teams_, point_, iteration);
  if (!own) return tl::unexpected<Error>(own.error());
  const auto state = play(*own);
  if (!state) return tl::unexpected<Error>(state.error());
  if (!*state) return {};
  const double result = iterationResult(plan_, (*state)->schedule, (*state)->results);
  outcome_.results.push_back(result);
  point_ = nextPoint(plan_.spsa, point_, iteration, result);
  return {};
}

Result<void> TuneRun::judge() {
  const auto finals = finalPlans(plan_, teams_, point_);
  if (!finals) return tl::unexpected<Error>(finals.error());
  for (const FinalPlan& final : *finals) {
    const auto state = play(final.plan);
    if (!state) return tl::unexpected<Error>(state.error());
    if (!*state) return {};
    FinalResult result{final.first, final.second, {}, {}};
    for (const auto& pair : (*state)->results) {
      result.counts.add(pair->points());
      result.points.push_back(pair->points());
    }
    outcome_.finals.push_back(std::move(result));
  }
  return {};
}

Result<TuneOutcome> TuneRun::all() {
  const auto iterations = static_cast<std::size_t>(plan_.spsa.iterations);
  while (!stopped() && outcome_.results.size() < iterations) {
    if (auto done = iterate(); !done) return tl::unexpected<Error>(done.error());
  }
  if (!stopped()) {
    if (auto done = judge(); !done) return tl::unexpected<Error>(done.error());
  }
  return std::move(outcome_);
}

}  // namespace

std::size_t matchesOf(const TunePlan& plan) {
  const auto pairs =
      static_cast<std::size_t>(plan.base.pairs) * static_cast<std::size_t>(plan.spsa.iterations);
  const auto finals = static_cast<std::size_t>(plan.final_pairs);
  return 2 * (plan.opponent ? 2 * pairs + 3 * finals : pairs + finals);
}

Result<TuneOutcome> runTune(const TunePlan& plan, const TeamCatalogue& teams, const TuneOptions& options) {
  if (auto checked = validate(plan); !checked) return tl::unexpected<Error>(checked.error());
  if (auto checked = checkPlan(plan.base); !checked) return tl::unexpected<Error>(checked.error());
  return TuneRun(plan, teams, options).all();
}

}  // namespace fulbito
