#include "experiments/comparison/paper_bars.hpp"

#include "experiments/comparison/paper_plan.hpp"
#include "experiments/comparison/summary.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {

TEST_CASE("the bars of Figs 28 and 29 are the pairs that both methods solve in time", "[unit]") {
  ComparisonConfig config;
  config.trials = 6;
  config.seed = 606;
  config.speeds = {1.0};
  config.pictures = 0;
  config.navigators = {"bezier", kClassicBezier, kUntunedField, kWideField};
  auto comparison = planComparison(config);
  REQUIRE(comparison);
  REQUIRE(runComparison(*comparison, {}, {}));
  // One run of the field hangs, and one run of Bezier is slower and longer than that of the field.
  auto records = [&](std::size_t block, std::size_t n) { return recordsOf(*comparison, block, n); };
  TrialScore& hung = const_cast<TrialRecord&>(records(0, 2)[4]).score;
  hung.time = 5.0 * hung.time_limit;
  TrialScore &slow = const_cast<TrialRecord&>(records(0, 0)[1]).score,
             &quick = const_cast<TrialRecord&>(records(0, 2)[1]).score;
  slow.outcome = quick.outcome = TrialOutcome::kReached;
  quick.time = slow.time_limit, slow.time = 2.0 * slow.time_limit;
  slow.length = 2.0 * quick.length;

  const auto all = paperBars(*comparison);
  REQUIRE(all.size() == 2);
  const PaperBars& simulation = all.front();
  CHECK(std::string(simulation.paper->figure) == "Fig. 28");
  int solved = 0, slower = 0, longer = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    const TrialScore &b = records(0, 0)[i].score, &f = records(0, 2)[i].score;
    if (!b.success() || !f.success() || b.timeRatio() > kHung || f.timeRatio() > kHung) continue;
    ++solved;
    slower += b.time > f.time ? 1 : 0;
    longer += b.length > f.length ? 1 : 0;
  }
  CHECK(static_cast<int>(simulation.pairs.size()) == solved);
  CHECK(slowerPairs(simulation) == slower);
  CHECK(longerPairs(simulation) == longer);
  CHECK(slower >= 1);
  CHECK(longer >= 1);
  for (const LayoutPair& pair : simulation.pairs) CHECK(pair.index != 4);
  // The values that the paper's savings imply: 95.3 pixels at 25.6 % are savings from 372 pixels.
  const std::string report = barsReport(all);
  CHECK(report.find("372.3 px, 24.92 s") != std::string::npos);
  CHECK(report.find(" " + std::to_string(slower) + " of " + std::to_string(solved) + " |") !=
        std::string::npos);
}

}  // namespace fulbito
