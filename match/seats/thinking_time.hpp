#pragma once

#include <algorithm>

#include "fulbito/strategy.hpp"

namespace fulbito {

/// One team's remaining decision time.
class ThinkingTime {
 public:
  explicit ThinkingTime(const DecisionTime& limit) : limit_(limit) {}

  /// [s] Time that a decision in the period may take, the bank included.
  double left(int period) const { return limit_.decision + (period == period_ ? bank_ : limit_.bank); }
  /// Charges a decision of `seconds` wall time. The bank is full again in each new period.
  /// @return whether the decision is late
  bool late(double seconds, int period) {
    if (period != period_) bank_ = limit_.bank;
    period_ = period;
    const double beyond = std::max(0.0, seconds - limit_.decision);
    const bool covered = beyond <= bank_;
    bank_ = std::max(0.0, bank_ - beyond);
    return !covered;
  }

 private:
  DecisionTime limit_;
  int period_ = 0;
  double bank_ = 0.0;  ///< [s] left
};

}  // namespace fulbito
