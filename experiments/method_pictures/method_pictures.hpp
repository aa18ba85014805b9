#pragma once

#include <vector>

#include "fulbito/report.hpp"

namespace fulbito::sonar {

/// Figs 1 to 7 of P.-G. Kim et al. (2006) as still pictures, with the paper's lengths: what the parts of the
/// hybrid say of one place each. 1: the nearness diagram's walking area; 2, 3: its two situations of low
/// safety; 4: occupancy boxes; 5: the limit cycle; 6, 7: the table of directions, near and farther.
std::vector<ReportScene> methodPictures();

}  // namespace fulbito::sonar
