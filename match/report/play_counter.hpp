#pragma once

#include <array>

#include "fulbito/statistics.hpp"

namespace fulbito {

/// Counts how both teams stand and move, and where the ball is, for `MatchStatistics`. Allocates nothing.
class PlayCounter {
 public:
  /// For a match without ticks so far.
  PlayCounter() = default;
  explicit PlayCounter(const MatchConfig& config);

  /// Forgets the contacts of the play before.
  void begin() { mates_ = {}; }
  /// Adds a tick of play.
  void count(const MatchTick& tick, MatchStatistics& counted);

 private:
  /// A condition that holds, with pauses.
  struct Spell {
    Tick since = -1, last = -1;  ///< its first and its latest tick; -1: none
    bool counted = false;
  };
  /// What goes on between two robots of a team.
  struct Mates {
    Spell contact, lock;
  };
  using MatesByNumbers = std::array<std::array<Mates, kMaxTeamSize>, kMaxTeamSize>;

  void countBall(const MatchTick& tick, MatchStatistics& counted) const;
  void countTeam(const MatchTick& tick, TeamId team, TeamPlay& play) const;
  void countMates(const MatchTick& tick, MatchStatistics& counted);
  Tick grow(Spell& spell, Tick now) const;

  double half_length_ = 0.0, half_width_ = 0.0, half_mouth_ = 0.0;  ///< [m]
  double corner_ = 0.0;                                             ///< [m] legs of the corner triangles
  double ball_radius_ = 0.0;                                        ///< [m]
  Tick pause_ = 0, lock_ = 0, long_contact_ = 0;
  PerTeam<MatesByNumbers> mates_{};
};

}  // namespace fulbito
