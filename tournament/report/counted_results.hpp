#pragma once

#include <cstddef>
#include <vector>

#include "tournament/report/table.hpp"

namespace fulbito {

/// Numbers of the fixtures that count and have results, in the order of the schedule.
std::vector<std::size_t> countedFixtures(const TournamentState& state);

/// The entrant that plays as blue (seat 0) or yellow (seat 1) in leg 0 or 1.
inline std::size_t entrantAt(const Fixture& fixture, std::size_t leg, std::size_t seat) {
  return leg == seat ? fixture.a : fixture.b;
}

/// The identity of a match; all zero in a state without identities.
MatchId idOf(const TournamentState& state, std::size_t fixture, std::size_t leg);

/// "12.1": number of the fixture from 1, and of the match in its pair. All reports name matches so.
std::string numberOf(std::size_t fixture, std::size_t leg);

/// The outcome of a match for the team at blue's (0) or yellow's seat (1): its own worst fault, or kMercy if
/// it lost early.
MatchOutcome outcomeOfSeat(const MatchResult& result, std::size_t seat);

/// Results of many pairs, seen from one team.
class Tally {
 public:
  /// Adds a pair, seen from its team A or B.
  void add(const PairResult& pair, bool as_a);
  MeetingSummary summary() const;

 private:
  MeetingSummary sums_;
  PairCounts counts_;
  std::vector<double> points_;
};

}  // namespace fulbito
