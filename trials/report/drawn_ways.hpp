#pragma once

#include <vector>

#include "fulbito/experiment.hpp"
#include "trials/comparison/paper_figures.hpp"

namespace fulbito {

/// The navigators of a block whose ways the picture of a layout shows, in order. Of the paper's own cases
/// those of its figure. Otherwise at most `ComparisonConfig::ways` of them: what Jung & Lee compare, then the
/// fastest over all trials. Needs the summary.
/// @param figure  null: the layout belongs to none
std::vector<std::size_t> drawnWays(const Comparison& comparison, std::size_t block, const FigureCase* figure);

}  // namespace fulbito
