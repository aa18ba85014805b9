#pragma once

#include <cstdint>

#include "fulbito/match.hpp"

namespace fulbito {

/// Adds up the time of each stage of the loop; reads no clock before `start`.
class StageClock {
 public:
  /// Measures into `profile` from now on.
  void start(const MatchClock& now, MatchProfile& profile) {
    now_ = now;
    profile_ = &profile;
  }
  /// Marks the beginning of a stage.
  void begin() {
    if (profile_ != nullptr) last_ = now_();
  }
  /// Adds the time since the last call to this stage.
  void lap(std::int64_t MatchProfile::* stage) {
    if (profile_ == nullptr) return;
    const std::int64_t now = now_();
    profile_->*stage += now - last_;
    last_ = now;
  }
  /// Counts a measured tick.
  void countTick() {
    if (profile_ != nullptr) ++profile_->ticks;
  }

 private:
  MatchClock now_;
  MatchProfile* profile_ = nullptr;
  std::int64_t last_ = 0;
};

}  // namespace fulbito
