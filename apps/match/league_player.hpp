#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bridge/wire/messages.hpp"
#include "fulbito/match.hpp"
#include "match/seats/seat.hpp"

namespace fulbito::app {

/// What a player has done so far.
struct LeagueCounts {
  std::int64_t frames = 0;      ///< of vision that it answered
  std::int64_t placements = 0;  ///< that it made
  std::int64_t odd = 0;         ///< frames with values that are not finite
};

/// A team of ours in a match of the league's simulator. It sees what vision and referee tell, as it would see
/// it in a match here, and its wheel speeds and placements go back to them.
class LeaguePlayer {
 public:
  /// @param config  rules, robots and the team itself; the other team does not play. Its latency is that of
  ///                the server: frames until commands act, beyond the next one
  /// Errors: as `Seat::create`.
  static Result<LeaguePlayer> create(const MatchConfig& config, TeamId team, const MatchClock& clock);

  /// Takes a command of the referee. At a foul, also at a repeated one, the team's placement.
  std::optional<wire::TeamPlaces> take(const wire::RefereeCommand& command);
  /// The team's wheel speeds for a frame. Errors: kUsage if the field is not that of the rules; kMachine or
  /// kInterrupted if the machine failed the team; kBadInput if the team failed too often.
  Result<wire::Packet> play(const wire::Vision& vision);
  /// Tells the team that the match is over.
  void end();

  /// Whether the referee has halted a match that was played.
  bool halted() const { return told_ && told_->foul == wire::Foul::kHalt && played_; }
  const LeagueCounts& counts() const { return counts_; }
  const TeamFaults& faults() const { return seat_.faults(); }
  /// Score as far as vision tells it.
  PerTeam<int> score() const { return state_.score; }
  /// [s] of play so far.
  double playSeconds() const;

 private:
  LeaguePlayer(const MatchConfig& config, TeamId team, Seat&& seat);
  void beginPeriod(wire::Half half);
  wire::TeamPlaces place(const wire::RefereeCommand& command);
  bool see(const wire::Vision& vision);
  void advance(std::uint32_t step);
  wire::Packet decide();
  /// What the last frame and the referee tell. @param later  [ticks] until commands act
  Moment moment(int later = 0) const { return {tick_ + later, &world_, ids_, &state_}; }

  MatchConfig config_;
  RefereeSetup setup_;
  TeamId team_;
  Seat seat_;
  RefereeState state_;
  WorldState world_;
  std::vector<RobotId> ids_;
  Tick tick_ = 0;
  std::optional<std::uint32_t> step_;          ///< [ms] of the last frame
  std::optional<wire::RefereeCommand> told_;   ///< the last one
  std::optional<wire::TeamPlaces> placement_;  ///< at the last foul
  bool ready_ = false;                         ///< the team knows where all stand
  bool played_ = false;
  LeagueCounts counts_;
};

}  // namespace fulbito::app
