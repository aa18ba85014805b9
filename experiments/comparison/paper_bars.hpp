#pragma once

#include <string>
#include <vector>

#include "experiments/comparison/paper_results.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {

/// Path lengths and times of both methods on one layout that both solve.
struct LayoutPair {
  std::uint64_t index = 0;
  double field_length = 0.0, bezier_length = 0.0;  ///< [m]
  double field_time = 0.0, bezier_time = 0.0;      ///< [s]
};

/// The data of Figs 28 and 29 of Jung & Lee (2015) layout by layout, from the runs whose means are nearest to
/// each figure. Hung runs are left out.
struct PaperBars {
  const PaperTarget* paper = nullptr;
  std::string suite;
  double speed = 0.0;  ///< [m/s]
  std::string bezier, field;
  std::vector<LayoutPair> pairs;
};

/// The bars of both figures, for each whose runs are in the comparison.
std::vector<PaperBars> paperBars(const Comparison& comparison);

/// Number of the pairs in which the Bezier method needs more time, or drives farther, than the field method.
int slowerPairs(const PaperBars& bars);
int longerPairs(const PaperBars& bars);

/// Markdown table: the paper's figures beside those of the comparison. Empty without bars.
std::string barsReport(const std::vector<PaperBars>& all);

}  // namespace fulbito
