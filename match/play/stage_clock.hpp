#pragma once

#include <cstdint>

#include "fulbito/match.hpp"

namespace fulbito {

/// Adds up how long each stage of the loop takes; reads no clock unless it was given one.
class StageClock {
 public:
  void start(const MatchClock& now, MatchProfile& profile) {
    now_ = now;
    profile_ = &profile;
  }
  /// A stage begins here.
  void begin() {
    if (profile_ != nullptr) last_ = now_();
  }
  /// What ran since the last call belongs to this stage.
  void lap(std::int64_t MatchProfile::* stage) {
    if (profile_ == nullptr) return;
    const std::int64_t now = now_();
    profile_->*stage += now - last_;
    last_ = now;
  }
  void countTick() {
    if (profile_ != nullptr) ++profile_->ticks;
  }

 private:
  MatchClock now_;
  MatchProfile* profile_ = nullptr;
  std::int64_t last_ = 0;
};

}  // namespace fulbito
