#pragma once

#include <vector>

#include "experiments/comparison/paper_figures.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {

/// The navigators of a block whose paths the picture of a layout shows, in order. For the paper's own cases
/// they are those of its figure. For others they are at most `ComparisonConfig::ways`: those that Jung & Lee
/// compare, then the fastest over all trials. Needs the summary.
/// @param figure  null if the layout belongs to no figure
std::vector<std::size_t> drawnWays(const Comparison& comparison, std::size_t block, const FigureCase* figure);

}  // namespace fulbito
