#pragma once

#include <functional>
#include <memory>
#include <span>

#include "match/config/match_faults.hpp"
#include "match/play/match_observer.hpp"

namespace fulbito {

/// A source of monotonic time [ns], for measuring only. Libraries read no clock of their own.
using MatchClock = std::function<std::int64_t()>;

/// Where the wall time of a match went [ns].
struct MatchProfile {
  std::int64_t sense = 0;     ///< what the teams see
  std::int64_t decide = 0;    ///< the teams' strategies
  std::int64_t navigate = 0;  ///< their navigators, and the policy for commands
  std::int64_t step = 0;      ///< physics and the hash of its state
  std::int64_t referee = 0;
  std::int64_t restart = 0;  ///< placing, and building worlds
  std::int64_t record = 0;   ///< all who watch
  std::int64_t ticks = 0;

  std::int64_t total() const { return sense + decide + navigate + step + referee + restart + record; }
};

/// What the referee of such a match goes by.
RefereeSetup refereeSetup(const MatchConfig& config);

/// One match: sense, decide, navigate, actuate, step, referee, record, tick by tick.
///
///     auto match = Match::create(config);
///     if (!match) return match.error();
///     match->watch(recorder);
///     while (match->step()) {}
class Match {
 public:
  /// Places the first play; the world can be looked at before the first step.
  /// Errors: kUsage or kBadInput of teams, rules, models, ranges and the start state.
  static Result<Match> create(const MatchConfig& config);
  Match(Match&&) noexcept;
  Match& operator=(Match&&) noexcept;
  ~Match();

  /// Watches from now on; must outlive the match. To be called before the first `step`.
  void watch(MatchObserver& observer);
  /// Measures where time goes; costs clock readings. `profile` must outlive the match. To be called before
  /// the first `step`.
  void measure(const MatchClock& now, MatchProfile& profile);
  /// A watchdog against hanging teams: a decision that takes longer than `limit` [ns] is not carried out, the
  /// one before is held. Off unless called; what it does depends on the machine's speed, so that such a match
  /// can be repeated only from its recording.
  void limitDecisionTime(const MatchClock& now, std::int64_t limit);

  /// Plays one control tick; false when the match is over. Allocates nothing once warm, but at restarts.
  bool step();
  /// Ends the match as it stands: those who watch are told. Also called by the last `step`.
  void finish();

  /// Where all stand now.
  Placement placement() const;
  /// Between ticks: goes on from this placement, the robots at rest, in a play and world of its own (kind
  /// kGiven). Clock and score stay. Those who watch are told with the next tick, so that of several
  /// replacements between two ticks only the last counts. Errors, which change nothing: kUsage when the match
  /// is over, or as `flawOfEdit` (match/play/edit.hpp) says; as `World::create`.
  Result<void> replace(const Placement& placement);
  /// How often play went on from a replacement.
  int edits() const;

  const MatchConfig& config() const;
  const RefereeState& referee() const;
  const WorldState& world() const;
  /// Of the world's robots.
  std::span<const RobotId> ids() const;
  /// Played so far; never reset.
  Tick tick() const;
  /// [s] simulated so far.
  double seconds() const;
  /// Hash over the states of all ticks so far.
  std::uint64_t hash() const;
  MatchFaults faults() const;

 private:
  struct Impl;
  explicit Match(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
