#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tournament/formats/schedule.hpp"
#include "tournament/identity/identity.hpp"
#include "tournament/statistics/sprt.hpp"
#include "tournament/store/match_cache.hpp"
#include "tournament/store/match_store.hpp"

namespace fulbito {

class MatchCache;

/// A part of a tournament for one of several machines: fixtures whose number leaves `index` when divided by
/// `count`.
struct Shard {
  std::size_t index = 0;
  std::size_t count = 1;
  bool has(std::size_t fixture) const { return fixture % count == index; }
};

/// A match that the machine failed in all attempts. It has no result.
struct UnplayedMatch {
  std::size_t fixture = 0;
  std::size_t leg = 0;
  std::string reason;
};

/// The state of a tournament: the plan and what has been played of it.
struct TournamentState {
  TournamentPlan plan;
  Schedule schedule;
  FixtureResults results;                   ///< by number of the fixture; as long as the schedule
  std::vector<std::array<MatchId, 2>> ids;  ///< of both matches, by number of the fixture
  std::optional<Sprt> sprt;  ///< fed with the results before the first gap; of a plan with a test
  /// Fixtures that count: all, or up to the verdict of the test.
  std::size_t counted = 0;
  std::vector<UnplayedMatch> unplayed;  ///< of the run that ends here, in the order of the schedule
  /// Whether nothing is left to play.
  bool finished() const;
};

/// Matches with results, of those that count, in which a team crashed or forfeited.
std::size_t failedMatches(const TournamentState& state);

/// A match that was played twice with different results.
struct Mismatch {
  Fixture fixture;
  std::size_t leg = 0;
  MatchResult first, second;
};

/// What a run tells while it goes on.
struct RunProgress {
  std::size_t done = 0;      ///< matches with results, of this shard
  std::size_t known = 0;     ///< matches that are known to be needed so far, at most; of this shard
  std::size_t failures = 0;  ///< matches so far that a team crashed in or forfeited
  std::optional<Sprt> sprt;  ///< of a plan with a test
};

/// What watches a match of a tournament.
struct MatchWatch {
  std::shared_ptr<MatchObserver> observer;
  /// Called when the match has ended, before its result is kept. kIo, kMachine: the match is played again.
  std::function<Result<void>()> finish;
};

/// How a tournament is run. None of this affects its results.
struct RunnerOptions {
  int jobs = 0;  ///< matches at once; 0: one per core
  Shard shard;
  MatchClock clock;                   ///< monotonic time [ns]
  MatchStore* log = nullptr;          ///< finished matches; required
  const MatchCache* cache = nullptr;  ///< matches of other tournaments; optional
  double verify = 0.0;                ///< share of the matches to play again and compare, 0 ... 1
  int retries = 2;  ///< further attempts of a match that the machine failed while no other ran
  /// Called with each finished match, from one thread at a time. False stops the run.
  std::function<bool(const RunProgress&)> progress;
  /// Called before each match is played. Empty: nothing watches.
  std::function<Result<MatchWatch>(const MatchConfig&, const MatchId&)> watch;
};

/// The result of a run.
struct RunOutcome {
  TournamentState state;
  std::vector<Mismatch> mismatches;  ///< of `verify`
  std::size_t played = 0;            ///< matches of this run
  std::size_t taken = 0;             ///< from log or cache
  std::size_t verified = 0;          ///< matches played again and compared
  std::size_t retried = 0;           ///< attempts that the machine failed
  bool interrupted = false;
};

/// The configuration of leg 0 or 1 of a fixture. Errors: as `applyStart`.
Result<MatchConfig> matchOf(const TournamentPlan& plan, const Fixture& fixture, std::size_t leg);

/// Plays what is missing. Matches that the log or the cache has are not played again; a team that is not
/// deterministic never plays from the cache. Matches that the machine fails are played again while fewer
/// others run; those that it fails in all attempts are left out, and end a test, which needs all results in
/// their order. Errors: kUsage of the plan; of a match; kIo of the log, with all results before it kept.
Result<RunOutcome> runTournament(const TournamentPlan& plan, const MatchIdentity& identity,
                                 const RunnerOptions& options);

/// What the log has of a tournament.
TournamentState stateOf(const TournamentPlan& plan, const MatchIdentity& identity, const MatchStore& log);

/// Checks all of a plan, teams and models too. Errors: kUsage naming the key; of a match.
Result<void> checkPlan(const TournamentPlan& plan);

}  // namespace fulbito
