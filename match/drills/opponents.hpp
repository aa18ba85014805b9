#pragma once

#include "match/drills/drill.hpp"

namespace fulbito {

/// The tested team's answer to its task.
struct ExerciseLog {
  bool offered = true;
  Tick asked = -1;  ///< tick of the observation of the answer that counts
  Vec2 answer;      ///< that answer, in the team's frame
};

/// A team whose robots each play their own role.
TeamChoice scriptedTeam(const std::array<DrillRole, kMaxTeamSize>& roles);

/// The tested team, which is asked for the task in every tick. `log` must outlive the teams.
TeamChoice exercisedTeam(const TeamChoice& team, const Exercise& exercise, ExerciseLog& log);

}  // namespace fulbito
