#pragma once

#include "engine/core/system/machine_room.hpp"
#include "match/drills/drill.hpp"

namespace fulbito {

/// The data that all trials and matches of a run share.
struct DrillRun {
  const DrillOptions& options;
  RobotPreset robot;
  PhysicsProfile physics;
  mutable MachineRoom room{};  ///< for trials that run at the same time
};

/// The match of a drill's trials, without teams, seed and start.
Result<MatchConfig> drillMatch(const DrillRun& run, const Drill& drill);

/// Plays trial `index`. Errors: of teams and of starts that cannot be placed.
Result<DrillTrial> playTrial(const DrillRun& run, const Drill& drill, const MatchConfig& base, int index);

/// The counts of one whole match, for the tested team.
struct DrillMatch {
  bool as_blue = true;
  int goals = 0;
  int conceded = 0;
  int own_goals = 0;
  int area_fouls = 0;
  int own_stalls = 0;
  int restarts = 0;
  int illegal = 0;      ///< restarts in which the referee had to repair the team's own places
  int early_goals = 0;  ///< conceded within 5 s of a restart
  bool roles_told = false;
  int switches = 0;
  int flaps = 0;
  double seconds = 0.0;  ///< length of play [s]
};

/// Plays match `index`: two in a row have one seed and exchanged sides.
Result<DrillMatch> playDrillMatch(const DrillRun& run, const Drill& drill, const MatchConfig& base,
                                  int index);

/// @{ The verdicts on the drill's bars.
std::vector<DrillVerdict> judgeTrials(const Drill& drill, const std::vector<DrillTrial>& trials);
std::vector<DrillVerdict> judgeMatches(const Drill& drill, const std::vector<DrillMatch>& matches);
/// @}

/// The goals ahead per full match.
double marginOf(const DrillMatch& match);

/// Sets `passed` by the value or its interval, and the bar.
void judge(DrillVerdict& verdict);

}  // namespace fulbito
