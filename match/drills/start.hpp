#pragma once

#include "match/drills/drill.hpp"

namespace fulbito {

/// One drawn start of a drill, in the frame of the tested team (blue).
struct DrillScene {
  int start = 0;  ///< index of the drill's start
  Placement placement;
  PerTeam<std::array<DrillRole, kMaxTeamSize>> roles{};
  Exercise exercise;
  TeamId seat = TeamId::kBlue;  ///< colour that the tested team plays as
};

/// Least distance [m] from which a keeper that starts `kGap` off can reach a ball of `speed` [m/s]:
/// d* = v (T + sqrt(2 g / a)), with a share of the robot's acceleration as a.
double leastSavableDistance(const Drill& drill, const RobotModel& robot, double speed);

/// The start of trial `index`: a pure function of the drill, its seed and the index. Starts take turns;
/// within each, every second trial is mirrored about the x axis and every second pair is played on the other
/// side. Errors: kBadInput when no free place was found for a body.
Result<DrillScene> drawScene(const Drill& drill, const MatchConfig& match, std::uint64_t seed, int index);

/// The restart that the scene begins with, in the world's frame: with the rules' own placement.
RestartCall openingOf(const DrillStart& start, const DrillScene& scene, const MatchConfig& match);

/// Whether the referee places the robots: the start has a restart and no robots of its own.
bool placedByReferee(const DrillStart& start, const DrillScene& scene);

/// The placement in the world's frame if the tested team has that seat and blue defends the left goal.
Placement seated(const Placement& placement, TeamId seat);

}  // namespace fulbito
