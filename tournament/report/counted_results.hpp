#pragma once

#include <cstddef>
#include <vector>

#include "tournament/report/table.hpp"

namespace fulbito {

/// Numbers of the fixtures that count and have results, in the order of the schedule.
std::vector<std::size_t> countedFixtures(const TournamentState& state);

/// The entrant that plays blue (seat 0) or yellow (seat 1) in leg 0 or 1.
inline std::size_t entrantAt(const Fixture& fixture, std::size_t leg, std::size_t seat) {
  return leg == seat ? fixture.a : fixture.b;
}

/// The identity of a match; all zero if the state has no identities.
MatchId idOf(const TournamentState& state, std::size_t fixture, std::size_t leg);

/// "12.1": number of the fixture from 1, and of the match in its pair. All reports name matches like this.
std::string numberOf(std::size_t fixture, std::size_t leg);

/// The outcome of a match for the team of blue (seat 0) or yellow (seat 1): the team's own worst fault, or
/// kMercy if it lost early.
MatchOutcome outcomeOfSeat(const MatchResult& result, std::size_t seat);

/// Sums the results of many pairs from the view of one team.
class Tally {
 public:
  /// Adds a pair. `as_a`: the team is A of the pair, otherwise B.
  void add(const PairResult& pair, bool as_a);
  MeetingSummary summary() const;

 private:
  MeetingSummary sums_;
  PairCounts counts_;
  std::vector<double> points_;
};

}  // namespace fulbito
