#pragma once

#include <optional>
#include <string_view>

#include "match/play/match_observer.hpp"

namespace fulbito {

/// [s] of play within which a goal is put down to a foul of the team that scores: the foul paid.
inline constexpr double kFoulPaysWithin = 5.0;

/// Finds the goals that follow a foul of the very team that scores them.
class FoulGoalFinder {
 public:
  /// Takes in an event after `played` ticks of play of `dt` [s]. A value: it is a goal of a team that was
  /// called for that clause at most `kFoulPaysWithin` of play ago.
  std::optional<std::string_view> take(const GameEvent& event, Tick played, double dt);

 private:
  struct Foul {
    Tick played = 0;
    std::string_view clause;
  };
  PerTeam<std::optional<Foul>> last_;
};

/// Counts these goals of a match that it watches, by the team that scores.
class FoulGoalCounter final : public MatchObserver {
 public:
  const PerTeam<int>& goals() const { return goals_; }

  void matchBegins(const MatchConfig& config) override { dt_ = config.physics.controlPeriod(); }
  void ticked(const MatchTick& tick) override;

 private:
  double dt_ = 0.0;
  FoulGoalFinder finder_;
  PerTeam<int> goals_{};
};

}  // namespace fulbito
