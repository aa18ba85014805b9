#pragma once

#include <vector>

#include "tournament/formats/schedule.hpp"

namespace fulbito {

/// A ladder so far.
struct LadderCourse {
  Schedule schedule;
  std::vector<std::size_t> order;  ///< entrants after the last round with all results, the upper first
};

/// The ladder begins in order of seeding. In even rounds places 1-2, 3-4 ... meet, in odd ones 2-3, 4-5 ...
/// The lower one takes the upper's place if it wins the meeting (`MeetingScore::winner`). Entrants who meet
/// again go on with the starts after those of their last meeting: equal starts would repeat the same matches.
LadderCourse ladderCourse(const TournamentPlan& plan, ResultsView results);

}  // namespace fulbito
