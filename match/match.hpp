#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "match/match_observer.hpp"

namespace fulbito {

/// A source of monotonic time [ns], for measuring only. Libraries read no clock of their own.
using MatchClock = std::function<std::int64_t()>;

/// Where the wall time of a match went [ns].
struct MatchProfile {
  std::int64_t sense = 0, decide = 0, navigate = 0, step = 0, referee = 0, record = 0;
};

/// One match: sense, decide, navigate, actuate, step, referee, record, tick by tick.
class Match {
 public:
  /// Errors: kUsage or kBadInput of teams, rules and models.
  static Result<Match> create(const MatchConfig& config);
  Match(Match&&) noexcept;
  Match& operator=(Match&&) noexcept;
  ~Match();

  /// Watches from now on; must outlive the match. To be called before the first `step`.
  void watch(MatchObserver& observer);
  /// Measures where time goes; costs clock readings. To be called before the first `step`.
  void measure(const MatchClock& now, MatchProfile& profile);
  /// Plays one control tick; false when the match is over.
  bool step();
  /// Ends the match as it stands: observers are told.
  void finish();

  const RefereeState& referee() const;
  const WorldState& world() const;
  Tick tick() const;
  /// Hash over the states of all ticks so far.
  std::uint64_t hash() const;

 private:
  struct Impl;
  explicit Match(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
