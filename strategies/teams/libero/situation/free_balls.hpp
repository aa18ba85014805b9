#pragma once

#include "fulbito/strategy.hpp"

namespace fulbito::libero {

/// Watches what the free balls of a match in the opponents' half bring.
class FreeBalls {
 public:
  /// Forgets the match.
  void forget() { *this = {}; }

  /// @param play_began  whether this is the first picture of a play
  /// @param soon        [s] after the signal: a goal until then counts as that of the free ball
  void watch(const Observation& seen, bool play_began, double soon);

  /// Whether to wait for one: until those that brought nothing are two more than those that brought a goal.
  /// Against an equal, play that goes on brings more than a free ball.
  bool pay() const { return taken_ - (open_ ? 1 : 0) - 2 * goals_ < 2; }

 private:
  int taken_ = 0, goals_ = 0;
  int score_ = 0;      // own goals when the last one began
  bool open_ = false;  // whether the last one may still bring a goal
};

}  // namespace fulbito::libero
