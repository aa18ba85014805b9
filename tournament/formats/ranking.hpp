#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tournament/formats/standings.hpp"

namespace fulbito {

/// A value that tables are ranked by; larger values come first.
struct Criterion {
  std::string_view name;       ///< text for `Standing::decided_by`
  std::vector<double> values;  ///< by entrant
};

/// Sorts lines by the criteria in order; equal lines by number of entrant. Sets `Standing::decided_by` of
/// each line to the criterion that separates it from the line above, or to nothing. The first line keeps its
/// text.
/// @return the blocks of two or more lines that no criterion separates
std::vector<std::span<Standing>> sortBy(std::span<Standing> lines, std::span<const Criterion> criteria);

/// Gives ranks to lines that `sortBy` has sorted. Does not show the name `silent` as deciding criterion.
void giveRanks(std::span<Standing> lines, std::string_view silent);

/// Applies `sortBy`, then `giveRanks`. Returns the sorted table.
std::vector<Standing> ranked(std::vector<Standing> table, std::span<const Criterion> criteria,
                             std::string_view silent);

}  // namespace fulbito
