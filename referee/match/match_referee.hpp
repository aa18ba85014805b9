#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "fulbito/referee.hpp"
#include "referee/calls/calls.hpp"
#include "referee/calls/detectors.hpp"
#include "referee/state/match_view.hpp"

namespace fulbito {

/// Referee of a whole match: clock, periods, calls and restarts. A plain value: a copy continues identically.
/// The same setup and the same views give the same calls; randomness comes only from the match's seed.
class MatchReferee {
 public:
  explicit MatchReferee(const RefereeSetup& setup);
  /// The match's first restart: the kick-off of the team that won the toss.
  RestartCall open();
  /// Processes one tick and appends its events. If it returns a call, play has stopped: place all robots
  /// (`place`) and call `restarted` before the next tick. Returns none after `state().ended`.
  std::optional<RestartCall> observe(const MatchView& view, std::vector<GameEvent>& events);
  /// Ticks from the placement to the signal: the call's delay, or 0 after `max_repeats` false starts.
  Tick delayOf(const RestartCall& call) const;
  /// To call once all robots stand as placed: play begins after `delayOf` the call. `tick` is the match's
  /// tick.
  void restarted(const RestartCall& call, const Placement& placement, Tick tick);

  /// A present team can no longer play: it counts as absent, and the next tick ends the match (law 7.3).
  void forfeit(TeamId team);

  const RefereeState& state() const { return state_; }
  const RefereeSetup& setup() const { return setup_; }
  /// Play time [s] left in the period (overtime: in its part; shoot-out: in the kick).
  double remaining() const;

 private:
  using Events = std::vector<GameEvent>;

  GameEvent eventOf(const MatchView& view, std::string_view clause, std::string_view law) const;
  TeamId toss(std::uint64_t index) const;
  void beginPeriod(int period);
  Tick periodTicks() const;
  RestartCall kickOff(TeamId team, const MatchView* view) const;
  std::optional<RestartCall> waitForSignal(const MatchView& view, Events& events);
  std::optional<RestartCall> walkOver(const MatchView& view, Events& events);
  std::optional<RestartCall> conclude(const Finding& finding, const MatchView& view, Events& events);
  std::optional<RestartCall> concludeGoal(const Finding& finding, const MatchView& view, Events& events);
  std::optional<RestartCall> endPeriod(const MatchView& view, Events& events);
  std::optional<RestartCall> afterRegularTime(const MatchView& view, Events& events);
  RestartCall beginOvertime(int part, const MatchView& view, Events& events);
  RestartCall beginShootOut(const MatchView& view, Events& events);
  std::optional<RestartCall> kick(const MatchView& view, Events& events);
  std::optional<RestartCall> endKick(bool goal, const MatchView& view, Events& events);
  void callBack(bool all);
  void finish(const MatchView& view, Events& events);

  RefereeSetup setup_;
  RefereeState state_;
  DetectorMemory memory_;
  bool forfeited_ = false;
};

}  // namespace fulbito
