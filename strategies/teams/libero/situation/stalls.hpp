#pragma once

#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Watches stalls: balls that lie still with opponents at them. Whoever attacks can end one: it withdraws,
/// and both play on. A team that always did so would lose to one that leans on. So libero offers one or
/// two, and goes on with opponents that give up theirs, too.
class Stalls {
 public:
  /// Forgets the match.
  void forget() { *this = {}; }

  /// Takes the next tick of the match; no robot has a role yet.
  void watch(const Picture& picture);

  /// Whether the field players withdraw from the ball now.
  bool isGivenUp() const { return withdrawing_ > 0.0; }

 private:
  double stallsAfter(const Picture& picture) const;
  bool opponentsDoToo(const Pitch& pitch) const;
  bool areKnownToWithdraw() const { return taken_ > leaned_; }
  void begin(const Picture& picture, double horizon);
  void watchOpponents(const Picture& picture);
  bool endsWithdrawal(const Picture& picture) const;

  int given_ = 0;             // stalls of their half that libero gave up
  int taken_ = 0;             // stalls of our half that the opponents gave up
  int leaned_ = 0;            // and those in which they leant on
  double withdrawing_ = 0.0;  // [s] left
  double watching_ = 0.0;     // [s] left, of a stall in our half
  Vec2 place_;                // [m] the ball when libero began to withdraw
};

}  // namespace fulbito::libero
