#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>

#include "match/config/match_faults.hpp"
#include "match/play/match_observer.hpp"
#include "strategies/interface/strategy.hpp"

namespace fulbito {

/// A source of monotonic time [ns]. Libraries read no clock of their own.
using MatchClock = std::function<std::int64_t()>;
/// Called before a tick that leads to the given one is played; returns when it may be.
using MatchPace = std::function<void(Tick)>;

/// Where a match stands, by what `Match::advance` does next.
enum class MatchPhase : std::uint8_t {
  kPlacing,  ///< play is stopped, or has not begun; next: the team of `Match::asked` says where it stands
  kPlaced,   ///< both have said it; next: the referee legalises it and the new world is built
  kReady,    ///< all stand in their new world; next: teams and observers are told
  kPlaying,  ///< next: one control tick
  kEnded,    ///< nothing follows
};

/// A team that is to say where it wants to stand, and what it is told.
struct AskedTeam {
  TeamId team = TeamId::kBlue;
  PlacementRequest request;
};

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
///
/// Between plays a match goes through phases. Who must wait for a team outside the process does so between
/// two of them, with the same results:
///
///     while (match->phase() != MatchPhase::kEnded) {
///       if (const auto asked = match->asked()) wait(*asked);
///       match->advance();
///     }
class Match {
 public:
  /// Makes both teams and tells them of the match. Asks for no placement: that is the first thing that
  /// happens, so that whoever watches sees it.
  /// @param clock  measures decisions where `config.decision_time` limits them; read for nothing else
  /// Errors: kUsage or kBadInput of teams, rules, models, ranges, the start state, and a limit without a
  /// clock.
  static Result<Match> create(const MatchConfig& config, const MatchClock& clock = {});
  Match(Match&&) noexcept;
  Match& operator=(Match&&) noexcept;
  ~Match();

  /// Watches from now on; must outlive the match. To be called before the first `step`, `advance` or
  /// `makeReady`.
  void watch(MatchObserver& observer);
  /// Measures where time goes; costs clock readings. `profile` must outlive the match. To be called before
  /// the first `step`.
  void measure(const MatchClock& now, MatchProfile& profile);
  /// Ties ticks to a clock outside: `wait` returns when the next tick may be played. What it takes counts
  /// neither as a team's time to think nor in a profile.
  void pace(MatchPace wait);

  MatchPhase phase() const;
  /// In phase kPlacing: who is asked next, and what.
  std::optional<AskedTeam> asked() const;
  /// Does the one thing that `phase` names and returns the phase that follows.
  MatchPhase advance();
  /// Goes on until nobody need be asked: the next thing is to begin a play, to play a tick, or nothing. For
  /// who wants to look at the world before the first step.
  MatchPhase makeReady();
  /// Plays one control tick and goes on up to the next; false when the match is over. Allocates nothing once
  /// warm, but at restarts.
  bool step();
  /// Ends the match as it stands: teams and all who watch are told. Also called by the last `step`.
  void finish();

  /// Where all stand now; nobody before the first placement.
  Placement placement() const;
  /// Between ticks: goes on from this placement, the robots at rest, in a play and world of its own (kind
  /// kGiven). Clock and score stay. Those who watch are told with the next tick, so that of several
  /// replacements between two ticks only the last counts. Errors, which change nothing: kUsage when the match
  /// is over or placements are asked for, or as `flawOfEdit` (match/play/edit.hpp) says; as `World::create`.
  Result<void> replace(const Placement& placement);
  /// How often play went on from a replacement.
  int edits() const;

  const MatchConfig& config() const;
  const RefereeState& referee() const;
  /// Without bodies before the first placement.
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
