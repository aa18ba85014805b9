#include <algorithm>
#include <map>
#include <numeric>

#include "tournament/formats/format.hpp"
#include "tournament/formats/meeting.hpp"

namespace fulbito {
namespace {

/// The state of a ladder.
struct LadderCourse {
  Schedule schedule;
  std::vector<std::size_t> order;  ///< entrants after the last complete round, the top of the ladder first
};

/// A meeting of the entrants at place `upper` and at the place below it.
struct Challenge {
  std::size_t upper = 0;
  MeetingFixtures fixtures;
};

class Ladder {
 public:
  explicit Ladder(const TournamentPlan& plan) : plan_(plan) {
    course_.order.resize(plan.entrants.size());
    std::iota(course_.order.begin(), course_.order.end(), std::size_t{0});
  }

  std::vector<Challenge> addRound(int round) {
    std::vector<Challenge> challenges;
    for (auto i = static_cast<std::size_t>(round % 2); i + 1 < course_.order.size(); i += 2) {
      challenges.push_back({i, addChallenge(course_.order[i], course_.order[i + 1], round)});
    }
    return challenges;
  }

  /// Exchanges the places of challengers who won. Returns whether all results exist; otherwise nothing
  /// changes.
  bool settle(const std::vector<Challenge>& challenges, ResultsView results) {
    std::vector<std::size_t> order = course_.order;
    for (const auto& [upper, fixtures] : challenges) {
      MeetingScore score;
      if (!addResults(results, fixtures, score)) return false;
      if (score.winner() == 1u) std::swap(order[upper], order[upper + 1]);
    }
    course_.order = std::move(order);
    return true;
  }

  LadderCourse take(bool complete) {
    course_.schedule.complete = complete;
    return std::move(course_);
  }

 private:
  MeetingFixtures addChallenge(std::size_t upper, std::size_t lower, int round) {
    const int earlier = meetings_[std::minmax(upper, lower)]++;
    const auto start = static_cast<std::size_t>(earlier) * static_cast<std::size_t>(plan_.pairs);
    return addMeeting(course_.schedule.fixtures, {upper, lower, round, start}, plan_.pairs);
  }

  const TournamentPlan& plan_;
  LadderCourse course_;
  // Meetings scheduled so far, by pair of entrants.
  std::map<std::pair<std::size_t, std::size_t>, int> meetings_;
};

/// The ladder begins in order of seeding. In even rounds places 1-2, 3-4, ... meet, in odd rounds 2-3, 4-5,
/// ... The lower entrant takes the upper place if it wins the meeting (`MeetingScore::winner`). Entrants who
/// meet again continue with the next starts, because equal starts would repeat the same matches.
LadderCourse ladderCourse(const TournamentPlan& plan, ResultsView results) {
  Ladder ladder(plan);
  for (int round = 0; round < roundsOf(plan); ++round) {
    if (!ladder.settle(ladder.addRound(round), results)) return ladder.take(false);
  }
  return ladder.take(true);
}

Schedule ladderSchedule(const TournamentPlan& plan, ResultsView results) {
  return ladderCourse(plan, results).schedule;
}

/// Odd-even transposition sort: exchanges of neighbours in alternate pairs sort n entrants within n rounds.
int roundsToSort(std::size_t entrants) { return static_cast<int>(entrants); }

/// Ranks by the order of the ladder after the last complete round.
std::vector<Standing> ladderTable(const CountedResults& counted) {
  std::vector<Standing> table = tally(counted);
  Criterion place{"place", std::vector<double>(table.size())};
  double height = static_cast<double>(table.size());
  for (const std::size_t entrant : ladderCourse(counted.plan, counted.results).order) {
    place.values[entrant] = height;
    height -= 1.0;
  }
  return ranked(std::move(table), std::span(&place, 1), "");
}

}  // namespace

extern const Format kLadderFormat{
    .schedule = ladderSchedule, .table = ladderTable, .most_fixtures = mostOfRounds, .rounds = roundsToSort};

}  // namespace fulbito
