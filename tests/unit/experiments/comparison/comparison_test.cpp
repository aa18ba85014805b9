#include <nlohmann/json.hpp>

#include "experiments/comparison/comparison_parts.hpp"
#include "experiments/comparison/paper_plan.hpp"
#include "experiments/comparison/summary.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/experiment.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

ComparisonConfig small(const std::string& suite) {
  ComparisonConfig config;
  config.suite = suite;
  config.trials = 4;
  config.speeds = {1.0};
  config.navigators = {"straight", "bezier"};
  config.pictures = 1;
  return config;
}

Comparison ran(const ComparisonConfig& config) {
  auto comparison = planComparison(config);
  REQUIRE(comparison);
  REQUIRE(runComparison(*comparison, {}, {}));
  return std::move(*comparison);
}

}  // namespace

TEST_CASE("results are the same bytes on any number of threads", "[unit]") {
  ComparisonConfig config = small("corner");
  config.jobs = 1;
  const Comparison one = ran(config);
  config.jobs = 4;
  const Comparison four = ran(config);
  CHECK(resultsJson(one, 0.0) == resultsJson(four, 0.0));
  CHECK(trialsCsv(one) == trialsCsv(four));
  CHECK(markdownReport(one) == markdownReport(four));
}

TEST_CASE("results.json has the documented keys", "[unit]") {
  const auto json = nlohmann::json::parse(resultsJson(ran(small("corner")), 1.5));
  for (const char* key : {"schema_version", "suite", "seed", "build", "config", "summary", "wall_seconds"})
    CHECK(json.contains(key));
  REQUIRE(json["summary"].size() == 2);
  for (const char* key :
       {"suite", "speed", "navigator", "trials", "success_rate", "success_low", "success_high", "contacts",
        "safe_pairs", "length_ratio", "time_ratio", "time_ratio_all", "path_length_m", "time_s",
        "min_clearance_m", "compute_us_p50", "compute_us_p99"}) {
    CHECK(json["summary"][0].contains(key));
  }
  CHECK(json["summary"][1]["navigator"] == "bezier");
  CHECK(json["summary"][1]["success_rate"] == 1.0);
}

TEST_CASE("a failure counts as eight times the bound in time_ratio_all", "[unit]") {
  const Comparison comparison = ran(small("corner"));
  const SummaryRow& straight = comparison.summary[0];
  double expected = 0.0;
  for (const TrialRecord& r : recordsOf(comparison, 0, 0))
    expected += r.score.success() ? r.score.timeRatio() : 8.0;
  CHECK(straight.success.value < 1.0);
  CHECK(straight.time_ratio_all == Approx(expected / 4));
}

TEST_CASE("one trial of a suite can be run again and is the same trial", "[unit]") {
  ComparisonConfig config = small("corner");
  const Comparison all = ran(config);
  config.only = 2;
  const Comparison one = ran(config);
  REQUIRE(one.records.size() == 2);
  CHECK(one.records[1].final_hash == recordsOf(all, 0, 1)[2].final_hash);
  CHECK_FALSE(one.records[1].trace.empty());
}

TEST_CASE("safe pairs are the layouts that both solved", "[unit]") {
  const Comparison comparison = ran(small("corner"));
  int both = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    both += recordsOf(comparison, 0, 0)[i].score.success() && recordsOf(comparison, 0, 1)[i].score.success()
                ? 1
                : 0;
  }
  CHECK(comparison.summary[0].safe_pairs == both);
  CHECK(compareSafePairs(comparison, 0, 1, 0).pairs == both);
}

TEST_CASE("the paper's suite judges every claim", "[unit]") {
  ComparisonConfig config;
  config.trials = 2;
  config.pictures = 0;
  const Comparison comparison = ran(config);
  std::string ids;
  for (const ReproductionRow& row : comparison.reproduction) {
    if (!row.id.ends_with("-with-hung")) ids += row.id + " ";
    CHECK_FALSE(row.ours.empty());
    CHECK_FALSE(row.reason.empty());
    // The distance to the paper's value, if there is one, is stated correctly, whatever the band is.
    CHECK(row.off_paper.has_value() == (row.paper.find('%') != std::string::npos));
    if (row.off_paper) {
      CHECK(*row.off_paper == Approx(std::stod(row.ours) - std::stod(row.paper)).margin(0.051));
    }
  }
  const auto json = nlohmann::json::parse(resultsJson(comparison, 0.0))["reproduction"][0];
  CHECK(json.contains("inside_our_band"));
  CHECK(json.contains("our_band"));
  CHECK(json.contains("off_paper_points"));
  CHECK(markdownReport(comparison).find("| our band | inside our band |") != std::string::npos);
  CHECK(ids ==
        "distance-untuned-univector time-untuned-univector distance-tuned-tangent-1.0 "
        "time-tuned-tangent-1.0 distance-tuned-tangent-2.6 time-tuned-tangent-2.6 distance-wide-ring "
        "time-wide-ring distance-wide-ring-previewed time-wide-ring-previewed distance-tuned-ring-corner "
        "time-tuned-ring-corner distance-tuned-ring-close-range time-tuned-ring-close-range "
        "collisions-as-printed collisions-guarded ");
}

TEST_CASE("a block's start heading turns the layout and nothing else", "[unit]") {
  auto comparison = planComparison(small("corner"));
  REQUIRE(comparison);
  ComparisonBlock& block = comparison->blocks.front();
  const auto laid_out = trialConfig(*comparison, block, 0, 1);
  block.heading = StartHeading::kAway;
  const auto away = trialConfig(*comparison, block, 0, 1);
  block.heading = StartHeading::kRandom;
  const auto random = trialConfig(*comparison, block, 0, 1), again = trialConfig(*comparison, block, 1, 1);
  const auto other = trialConfig(*comparison, block, 0, 2);
  REQUIRE(random);
  CHECK(std::abs(math::wrapAngle(away->layout.start.heading - laid_out->layout.start.heading)) ==
        Approx(171.0 * math::kPi / 180.0));
  CHECK(random->layout.start.heading == again->layout.start.heading);
  CHECK(random->layout.start.heading != other->layout.start.heading);
  CHECK(random->layout.start.heading != laid_out->layout.start.heading);
  CHECK(random->layout.start.position == laid_out->layout.start.position);
  CHECK(random->layout.obstacles.front().pose.position == laid_out->layout.obstacles.front().pose.position);
}

TEST_CASE("differences over several blocks are those of all their pairs", "[unit]") {
  ComparisonConfig config = small("corner");
  config.navigators = {"bezier", "tangent-graph"};
  config.speeds = {1.0, 1.0};
  Comparison comparison = ran(config);
  const std::vector<std::size_t> both = {0, 1};
  const PairedDifference one = compareSafePairs(comparison, 0, 0, 1),
                         two = compareSafePairs(comparison, both, 0, 1, kNeverHung, 100);
  CHECK(two.pairs == 2 * one.pairs);
  CHECK(two.length.value == Approx(one.length.value));
  // A run that takes over four times the bound has hung. It is left out only on request.
  const_cast<TrialRecord&>(recordsOf(comparison, 0, 1)[0]).score.time *= 10.0;
  CHECK(compareSafePairs(comparison, 0, 0, 1, kHung).pairs == one.pairs - 1);
  CHECK(compareSafePairs(comparison, 0, 0, 1).pairs == one.pairs);
}

TEST_CASE("wrong questions are refused before anything runs", "[unit]") {
  const auto messageOf = [](const ComparisonConfig& config) {
    const auto plan = planComparison(config);
    REQUIRE_FALSE(plan);
    return plan.error().message;
  };
  ComparisonConfig config = small("corner");
  config.suite = "jung-lee";
  CHECK(messageOf(config) == "there is no suite 'jung-lee'. Did you mean 'jung-lee-2015'?");
  config = small("corner");
  config.navigators = {"bezir"};
  CHECK(messageOf(config) == "there is no navigator 'bezir'. Did you mean 'bezier'?");
  config.navigators = {"bezier:clerance=0.1"};
  CHECK(messageOf(config) == "'bezier' has no parameter 'clerance'. Did you mean 'clearance'?");
  config = small("corner");
  config.speeds = {-1.0};
  CHECK(messageOf(config) == "--speeds: -1 is outside 0.05 ... 10 m/s");
  config = small("corner");
  config.only = 4;
  CHECK(messageOf(config) == "--only: 4 is outside 0 ... 3 (suite corner)");
  config = small("corner");
  config.robot = "vss";
  CHECK(messageOf(config).find("Did you mean 'vsss'?") != std::string::npos);
}

TEST_CASE("a run can be stopped", "[unit]") {
  auto comparison = planComparison(small("corner"));
  REQUIRE(comparison);
  const auto stopped = runComparison(*comparison, {}, [](std::size_t, std::size_t) { return false; });
  REQUIRE_FALSE(stopped);
  CHECK(stopped.error().code == ErrorCode::kInterrupted);
}

}  // namespace fulbito
