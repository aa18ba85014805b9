#pragma once

#include <optional>
#include <string>
#include <vector>

#include "match/check/watched_team.hpp"

namespace fulbito {

/// A team's answers to recorded calls.
struct TeamAnswers {
  std::vector<TeamCommand> commands;                ///< one per decision
  std::vector<std::optional<TeamProposal>> places;  ///< one per placement request
  std::string failure;  ///< why the team stopped answering; empty: it answered all
};

/// Tells a new instance of the team all recorded calls, one after the other. Stops at the first answer that
/// is late or missing. Errors: of the team.
Result<TeamAnswers> answersOf(const TeamChoice& team, const RecordedCalls& told);

/// The recorded calls as the team of the other colour gets them. Only the colour differs, since calls are in
/// a team's own frame.
RecordedCalls inOtherSeat(RecordedCalls told);

/// The calls before the first play that begins with the ball on the long axis. From there, left and right are
/// equal and a team must choose, but its mirror image makes the same choice.
RecordedCalls offAxis(RecordedCalls told);

/// The recorded calls mirrored across the long axis.
RecordedCalls mirrored(RecordedCalls told);

/// How two series of answers compare.
struct AnswerDifference {
  int compared = 0;   ///< decisions and placements
  int different = 0;  ///< answers that differ
  int first = -1;     ///< index of the first different decision; -1: none
  int robot = -1;     ///< robot of that decision
};

/// Compares two series of answers bit by bit, up to the end of the shorter one. Robots that are not on the
/// field do not count.
AnswerDifference compareAnswers(const RecordedCalls& told, const TeamAnswers& a, const TeamAnswers& b);

/// Compares answers with the answers to the mirrored calls, within a rounding tolerance.
AnswerDifference compareMirrored(const RecordedCalls& told, const TeamAnswers& a, const TeamAnswers& mirror);

}  // namespace fulbito
