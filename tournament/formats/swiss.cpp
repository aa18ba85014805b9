#include "tournament/formats/swiss.hpp"

#include "tournament/formats/meeting.hpp"
#include "tournament/formats/swiss_pairing.hpp"

namespace fulbito {
namespace {

class Swiss {
 public:
  explicit Swiss(const TournamentPlan& plan)
      : plan_(plan),
        pairing_(plan.entrants.size(), static_cast<std::size_t>(roundsOf(plan))),
        points_(plan.entrants.size()) {}

  /// Returns whether all results of the round exist.
  bool playRound(int round, ResultsView results) {
    bool all = true;
    for (const auto& [a, b] : pairing_.next(points_)) {
      if (b == plan_.entrants.size()) {
        points_[a] += plan_.pairs;
      } else {
        all = meet({a, b, round, 0}, results) && all;
      }
    }
    return all;
  }

  Schedule take(bool complete) {
    schedule_.complete = complete;
    return std::move(schedule_);
  }

 private:
  bool meet(const Fixture& first, ResultsView results) {
    MeetingScore score;
    const bool all = addResults(results, addMeeting(schedule_.fixtures, first, plan_.pairs), score);
    points_[first.a] += score.points[0] / 2;
    points_[first.b] += score.points[1] / 2;
    return all;
  }

  const TournamentPlan& plan_;
  SwissPairing pairing_;
  std::vector<double> points_;  // of pairs, by entrant
  Schedule schedule_;
};

}  // namespace

Schedule swissSchedule(const TournamentPlan& plan, ResultsView results) {
  Swiss swiss(plan);
  for (int round = 0; round < roundsOf(plan); ++round) {
    if (!swiss.playRound(round, results)) return swiss.take(false);
  }
  return swiss.take(true);
}

}  // namespace fulbito
