#pragma once

#include "engine/core/system/machine_room.hpp"
#include "match/drills/drill.hpp"

namespace fulbito {

/// What all trials and matches of a run have in common.
struct DrillRun {
  const DrillOptions& options;
  RobotPreset robot;
  PhysicsProfile physics;
  mutable MachineRoom room{};  ///< of the trials that play at once
};

/// The match that a drill's trials are played in, but for teams, seed and start.
Result<MatchConfig> drillMatch(const DrillRun& run, const Drill& drill);

/// Plays trial `index`. Errors: of teams and of starts that cannot be placed.
Result<DrillTrial> playTrial(const DrillRun& run, const Drill& drill, const MatchConfig& base, int index);

/// What came of one whole match, for the tested team.
struct DrillMatch {
  bool as_blue = true;
  int goals = 0;
  int conceded = 0;
  int own_goals = 0;
  int area_fouls = 0;
  int own_stalls = 0;
  int restarts = 0;
  int illegal = 0;      ///< placements of its own that had to be repaired
  int early_goals = 0;  ///< conceded within 5 s of a restart
  bool roles_told = false;
  int switches = 0;
  int flaps = 0;
  double seconds = 0.0;  ///< of play
};

/// Plays match `index`: two in a row have one seed and exchanged sides.
Result<DrillMatch> playDrillMatch(const DrillRun& run, const Drill& drill, const MatchConfig& base,
                                  int index);

/// @{ The drill's bars, judged.
std::vector<DrillVerdict> judgeTrials(const Drill& drill, const std::vector<DrillTrial>& trials);
std::vector<DrillVerdict> judgeMatches(const Drill& drill, const std::vector<DrillMatch>& matches);
/// @}

/// Sets `passed` from the value, its interval and the bar.
void judge(DrillVerdict& verdict);

}  // namespace fulbito
