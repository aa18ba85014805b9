#pragma once

#include <string>
#include <vector>

#include "fulbito/experiment.hpp"
#include "trials/comparison/paper_results.hpp"

namespace fulbito {

/// Way and time of both methods on one layout that both solve.
struct LayoutPair {
  std::uint64_t index = 0;
  double field_length = 0.0, bezier_length = 0.0;  ///< [m]
  double field_time = 0.0, bezier_time = 0.0;      ///< [s]
};

/// What Figs 28 and 29 of Jung & Lee (2015) show layout by layout, from the runs whose means come nearest to
/// each. Without hung runs.
struct PaperBars {
  const PaperTarget* paper = nullptr;
  std::string suite;
  double speed = 0.0;  ///< [m/s]
  std::string bezier, field;
  std::vector<LayoutPair> pairs;
};

/// The bars of both figures, as far as the comparison has their runs.
std::vector<PaperBars> paperBars(const Comparison& comparison);

/// Number of the pairs in which the Bezier method needs more time, or drives farther, than the field.
int slowerPairs(const PaperBars& bars);
int longerPairs(const PaperBars& bars);

/// Table for people: the paper's figures beside these. Empty without bars.
std::string barsReport(const std::vector<PaperBars>& all);

}  // namespace fulbito
