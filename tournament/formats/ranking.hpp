#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "tournament/formats/standings.hpp"

namespace fulbito {

/// What lines of a table are ranked by: larger values come first.
struct Criterion {
  std::string_view name;       ///< for `Standing::decided_by`
  std::vector<double> values;  ///< by entrant
};

/// Sorts lines by the criteria, the first first; equal lines by number of entrant. Names at each line the
/// criterion that separates it from the line above, or nothing. The first line keeps its name.
/// @return the blocks of two or more lines that no criterion separates
std::vector<std::span<Standing>> sortBy(std::span<Standing> lines, std::span<const Criterion> criteria);

/// Gives ranks to lines that `sortBy` has sorted. The first criterion goes without its name if it is
/// `silent`.
void giveRanks(std::span<Standing> lines, std::string_view silent);

/// `sortBy` and `giveRanks`.
std::vector<Standing> ranked(std::vector<Standing> table, std::span<const Criterion> criteria,
                             std::string_view silent);

}  // namespace fulbito
