#include "experiments/report/drawn_ways.hpp"

#include "experiments/comparison/paper_plan.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

struct Timed {
  std::string navigator;
  double time_ratio;  ///< mean over all trials
};

/// A comparison whose first block has two navigators and whose second block has those of `timed`.
Comparison comparisonOf(const std::vector<Timed>& timed, int ways) {
  Comparison comparison;
  comparison.config.ways = ways;
  comparison.blocks.resize(2);
  const auto add = [&](ComparisonBlock& block, const Timed& one) {
    auto choice = parseNavigator(one.navigator);
    REQUIRE(choice);
    block.navigators.push_back(std::move(*choice));
    SummaryRow row;
    row.time_ratio_all = one.time_ratio;
    comparison.summary.push_back(row);
  };
  for (const char* other : {"straight", "dwa"}) add(comparison.blocks[0], {other, 1.0});
  for (const Timed& one : timed) add(comparison.blocks[1], one);
  return comparison;
}

std::vector<std::string> shown(const std::vector<Timed>& timed, int ways) {
  const Comparison comparison = comparisonOf(timed, ways);
  std::vector<std::string> names;
  for (const std::size_t n : drawnWays(comparison, 1, nullptr)) {
    names.push_back(comparison.blocks[1].navigators[n].text);
  }
  return names;
}

}  // namespace

TEST_CASE("a picture shows the paper's methods first, then the fastest", "[unit]") {
  const std::vector<Timed> timed{{"straight", 8.0},    {"univector", 1.3},  {"dwa", 1.15},
                                 {"limit-cycle", 1.2}, {"bezier", 1.4},     {kTunedField, 1.25},
                                 {"hermite", 1.1},     {kUntunedField, 3.0}};
  CHECK(shown(timed, 5) == std::vector<std::string>{"bezier", kUntunedField, kTunedField, "hermite", "dwa"});
  CHECK(shown(timed, 2) == std::vector<std::string>{"bezier", kUntunedField});
  CHECK(shown(timed, 0) == std::vector<std::string>{"bezier", kUntunedField, kTunedField, "hermite", "dwa",
                                                    "limit-cycle", "univector", "straight"});
}

TEST_CASE("without the paper's settings a picture shows its methods as they are", "[unit]") {
  const std::vector<Timed> timed{{"dwa", 1.0}, {"univector", 2.0}, {"hermite", 1.1}, {"straight", 5.0}};
  CHECK(shown(timed, 3) == std::vector<std::string>{"univector", "dwa", "hermite"});
  CHECK(shown(timed, 9).size() == 4);
}

}  // namespace fulbito
