#pragma once

#include "match/drills/drill.hpp"

namespace fulbito {

/// What the tested team answered to its task.
struct ExerciseLog {
  bool offered = true;
  Tick asked = -1;  ///< tick of the observation of the answer that counts
  Vec2 answer;      ///< that one, in the team's frame
};

/// A team whose robots play their roles, each for itself.
TeamChoice scriptedTeam(const std::array<DrillRole, kMaxTeamSize>& roles);

/// The tested team, asked for the task at every tick. The log must outlive the teams that this makes.
TeamChoice exercisedTeam(const TeamChoice& team, const Exercise& exercise, ExerciseLog& log);

}  // namespace fulbito
