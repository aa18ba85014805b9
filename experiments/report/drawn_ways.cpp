#include "experiments/report/drawn_ways.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "experiments/comparison/paper_plan.hpp"

namespace fulbito {
namespace {

std::optional<std::size_t> navigatorNamed(const ComparisonBlock& block, const std::string& text) {
  for (std::size_t n = 0; n < block.navigators.size(); ++n) {
    if (block.navigators[n].text == text) return n;
  }
  return std::nullopt;
}

/// The navigators of a block that the case file of a figure lists.
std::vector<std::size_t> figureNavigators(const ComparisonBlock& block, const FigureCase& figure) {
  std::vector<std::size_t> chosen;
  for (std::size_t n = 0; n < block.navigators.size(); ++n) {
    if (runOf(figure, block.navigators[n].text) != nullptr) chosen.push_back(n);
  }
  return chosen;
}

/// The navigators that Jung & Lee compare, with the settings of their comparison if the block has them.
std::vector<std::size_t> paperNavigators(const ComparisonBlock& block) {
  std::vector<std::size_t> chosen;
  for (const auto& [exact, plain] : {std::pair{"bezier", "bezier"}, std::pair{kUntunedField, "univector"},
                                     std::pair{kTunedField, "tangent-field"}}) {
    auto found = navigatorNamed(block, exact);
    if (!found) found = navigatorNamed(block, plain);
    if (found) chosen.push_back(*found);
  }
  return chosen;
}

/// All navigators of a block in the order in which a picture prefers them: those of the paper, then by their
/// time over all trials.
std::vector<std::size_t> byInterest(const Comparison& comparison, std::size_t b) {
  std::size_t first_row = 0;
  for (std::size_t before = 0; before < b; ++before) first_row += comparison.blocks[before].navigators.size();
  const ComparisonBlock& block = comparison.blocks[b];
  std::vector<std::size_t> order = paperNavigators(block);
  const auto papers = static_cast<std::ptrdiff_t>(order.size());
  for (std::size_t n = 0; n < block.navigators.size(); ++n) {
    if (std::find(order.begin(), order.begin() + papers, n) == order.begin() + papers) order.push_back(n);
  }
  std::stable_sort(order.begin() + papers, order.end(), [&](std::size_t x, std::size_t y) {
    return comparison.summary[first_row + x].time_ratio_all <
           comparison.summary[first_row + y].time_ratio_all;
  });
  return order;
}

}  // namespace

std::vector<std::size_t> drawnWays(const Comparison& comparison, std::size_t b, const FigureCase* figure) {
  if (figure != nullptr) {
    auto chosen = figureNavigators(comparison.blocks[b], *figure);
    if (!chosen.empty()) return chosen;
  }
  std::vector<std::size_t> order = byInterest(comparison, b);
  const auto most = static_cast<std::size_t>(comparison.config.ways);
  if (most > 0 && order.size() > most) order.resize(most);
  return order;
}

}  // namespace fulbito
