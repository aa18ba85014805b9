#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tournament/formats/schedule.hpp"

namespace fulbito {

/// The score of one meeting of two entrants, A (0) and B (1), summed over its pairs.
struct MeetingScore {
  std::array<double, 2> points{};  ///< points of matches: 1 for a win, 1/2 for a draw
  std::array<int, 2> goals{};

  void add(const PairResult& pair);
  /// The winner, by points, then by goal difference: 0 for A, 1 for B. Empty if both are level.
  std::optional<std::size_t> winner() const;
};

/// The consecutive fixtures of one meeting, as a half-open range of fixture numbers.
struct MeetingFixtures {
  std::size_t begin = 0;  ///< number of the first fixture
  std::size_t end = 0;    ///< number after the last fixture
};

/// Appends `pairs` fixtures of a meeting. They copy `first`, with consecutive start numbers.
MeetingFixtures addMeeting(std::vector<Fixture>& fixtures, Fixture first, int pairs);

/// Adds the results of the meeting's fixtures to `score`. Returns whether all results exist.
bool addResults(ResultsView results, MeetingFixtures meeting, MeetingScore& score);

}  // namespace fulbito
