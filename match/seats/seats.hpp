#pragma once

#include <optional>
#include <span>
#include <vector>

#include "match/seats/seat.hpp"
#include "match/seats/stage_clock.hpp"

namespace fulbito {

/// The input of both seats for one tick.
struct SeatTick {
  Moment moment;          ///< state that the teams observe
  bool drawings = false;  ///< an observer wants the teams' drawings
  bool held = false;      ///< the robots wait for the signal of a restart
  GameEvent now;          ///< an event of this tick without a clause, to be filled in
};

/// Both seats of a match.
class Seats {
 public:
  /// Errors: as `Seat::create`, with the team's name.
  static Result<Seats> create(const MatchConfig& config, const MatchClock& clock);

  /// The first half of a tick: both teams observe it.
  void sense(const SeatTick& tick, StageClock& stages);
  /// The second half, from these observations to the wheel speeds: decide → navigate → actuate.
  /// @param events    faults of the teams are added
  /// @param commands  one per robot of the world, written
  /// Errors: kMachine, kInterrupted if the machine lacks resources for a team; then `commands` stays as it
  /// was.
  Result<void> act(const SeatTick& tick, StageClock& stages, std::vector<GameEvent>& events,
                   std::span<WheelSpeeds> commands);

  Seat& operator[](TeamId team) { return seats_[indexOf(team)]; }
  const Seat& operator[](TeamId team) const { return seats_[indexOf(team)]; }

 private:
  std::optional<Error> cut() const;

  std::vector<Seat> seats_;  ///< in the order of `kTeams`
};

}  // namespace fulbito
