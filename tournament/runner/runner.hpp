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

/// The part of a tournament that one of several machines plays: fixtures whose number modulo `count` is
/// `index`.
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

/// The state of a tournament: the plan and the results so far.
struct TournamentState {
  TournamentPlan plan;
  Schedule schedule;
  FixtureResults results;                   ///< by fixture number; as long as the schedule
  std::vector<std::array<MatchId, 2>> ids;  ///< identities of both matches, by fixture number
  std::optional<Sprt> sprt;  ///< test after the results before the first gap; empty without a test
  /// Number of fixtures that count: all, or those up to the verdict of the test.
  std::size_t counted = 0;
  /// Matches that the latest run left out, in the order of the schedule.
  std::vector<UnplayedMatch> unplayed;
  /// Whether there is no match left to play.
  bool finished() const;
};

/// Number of matches in which a team crashed or forfeited, among those that count and have results.
std::size_t failedMatches(const TournamentState& state);

/// A match that was played twice, with different results.
struct Mismatch {
  Fixture fixture;
  std::size_t leg = 0;
  MatchResult first, second;
};

/// The progress of a run.
struct RunProgress {
  std::size_t done = 0;      ///< matches of this shard with results
  std::size_t known = 0;     ///< upper limit for the matches of this shard that are known to be needed so far
  std::size_t failures = 0;  ///< matches so far in which a team crashed or forfeited
  std::optional<Sprt> sprt;  ///< the sequential test; empty if the plan has none
};

/// An observer of one match of a tournament.
struct MatchWatch {
  std::shared_ptr<MatchObserver> observer;
  /// Called at the end of the match, before its result is kept. After kIo or kMachine the match is played
  /// again.
  std::function<Result<void>()> finish;
};

/// Options that do not affect the results of a tournament.
struct RunnerOptions {
  int jobs = 0;  ///< matches played at once; 0: one per core
  Shard shard;
  MatchClock clock;                   ///< monotonic time [ns]
  MatchStore* log = nullptr;          ///< store of finished matches; required
  const MatchCache* cache = nullptr;  ///< cache of matches from other tournaments; optional
  double verify = 0.0;  ///< share of the matches from log or cache to play again and compare, 0 ... 1
  int retries = 2;      ///< further attempts for a match that the machine fails while no other match runs
  /// Called with each finished match, from one thread at a time. False stops the run.
  std::function<bool(const RunProgress&)> progress;
  /// Called before each match is played. Empty: matches have no observers.
  std::function<Result<MatchWatch>(const MatchConfig&, const MatchId&)> watch;
};

/// The result of a run.
struct RunOutcome {
  TournamentState state;
  std::vector<Mismatch> mismatches;  ///< matches that `verify` found to differ
  std::size_t played = 0;            ///< matches that this run played
  std::size_t taken = 0;             ///< matches taken from log or cache
  std::size_t verified = 0;          ///< matches played again and compared
  std::size_t retried = 0;           ///< attempts that failed because of the machine
  bool interrupted = false;
};

/// The configuration of leg 0 or 1 of a fixture. Errors: as `applyStart`.
Result<MatchConfig> matchOf(const TournamentPlan& plan, const Fixture& fixture, std::size_t leg);

/// Plays the missing matches. Matches in the log or the cache are not played again; the cache is not used for
/// teams that are not deterministic. Matches that the machine fails are tried again while fewer others run.
/// Matches that fail in all attempts are left out; they end a sequential test, which needs all results in
/// order. Errors: kUsage of the plan; of a match; kIo of the log (earlier results are kept).
Result<RunOutcome> runTournament(const TournamentPlan& plan, const MatchIdentity& identity,
                                 const RunnerOptions& options);

/// The state of a tournament with the results that the log has.
TournamentState stateOf(const TournamentPlan& plan, const MatchIdentity& identity, const MatchStore& log);

/// Checks everything in a plan, including teams and models. Errors: kUsage naming the key; of a match.
Result<void> checkPlan(const TournamentPlan& plan);

}  // namespace fulbito
