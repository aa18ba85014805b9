#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tournament/formats/schedule.hpp"

namespace fulbito {

/// The sum of the pairs of one meeting of two entrants, A (0) and B (1).
struct MeetingScore {
  std::array<double, 2> points{};  ///< of matches: 1 for a win, 1/2 for a draw
  std::array<int, 2> goals{};

  void add(const PairResult& pair);
  /// 0 for A, 1 for B: by points, then by goal difference. Empty if both are level.
  std::optional<std::size_t> winner() const;
};

/// Consecutive fixtures of one meeting.
struct MeetingFixtures {
  std::size_t begin = 0;  ///< number of the first one
  std::size_t end = 0;    ///< after the last one
};

/// Adds `pairs` fixtures of A against B, from the start number `start` on.
MeetingFixtures addMeeting(std::vector<Fixture>& fixtures, Fixture first, int pairs);

/// Adds the results that exist to `score`. Returns whether all exist.
bool addResults(ResultsView results, MeetingFixtures meeting, MeetingScore& score);

}  // namespace fulbito
