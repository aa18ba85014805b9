#pragma once

#include <map>
#include <string>
#include <vector>

#include "fulbito/match.hpp"
#include "tests/second_referee/moment.hpp"

namespace fulbito::second {

/// How often a clause was called, by both referees or by one alone.
struct Tally {
  int both = 0, match_alone = 0, second_alone = 0;
};

/// Watches a match tick by tick, re-derives every call from the states alone and compares it with what the
/// match's own referee called: tick, clause, team, robot, and the restart with the team that takes it.
/// Laws and clock: kick-off, half, full-time, goal, fouls, stuck balls, shoot-out. For matches with both
/// teams, no overtime, and robots held until the signal: `unfit`.
class SecondReferee final : public MatchObserver {
 public:
  /// Empty, or why it cannot judge matches of this configuration.
  static std::string unfit(const MatchConfig& config);

  void onMatchStart(const MatchConfig& config) override;
  void onPlayStart(const PlayStart& start) override;
  void onTick(const MatchTick& tick) override;

  const std::map<std::string, Tally>& tallies() const { return tallies_; }
  int calls() const;
  /// One line each; empty: both agree.
  const std::vector<std::string>& disagreements() const { return disagreements_; }

 private:
  void see(const MatchTick& tick);
  std::vector<Call> judge();
  std::vector<Call> judgeKick();
  Call half();
  Call afterFullTime();
  Call fullTime(const PerTeam<int>& score);
  void compare(const std::vector<Call>& calls, std::span<const GameEvent> events);

  MatchConfig config_;
  Play play_;
  bool announce_ = false;  ///< the next tick of play tells of the kick-off
  int period_ = 1;
  Tick played_ = 0;  ///< ticks of play in this half
  TeamId first_kick_off_ = TeamId::kBlue;
  PerTeam<int> score_{};
  bool shoot_out_ = false;
  PerTeam<int> kicks_{}, hits_{};  ///< of the shoot-out: taken, scored
  bool tossed_ = false;            ///< too many kicks: chance decides
  std::optional<Call> restart_;    ///< that must follow
  std::map<std::string, Tally> tallies_;
  std::vector<std::string> disagreements_;
};

}  // namespace fulbito::second
