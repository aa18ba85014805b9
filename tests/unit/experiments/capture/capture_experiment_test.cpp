#include "experiments/capture/capture_experiment.hpp"

#include <algorithm>
#include <set>

#include "experiments/capture/estimator_study.hpp"
#include "experiments/papers/report_output.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

Result<ExperimentReport> reportOf(std::vector<Setting> settings, int jobs) {
  ExperimentRequest request;
  request.settings = std::move(settings);
  request.jobs = jobs;
  return captureExperiment().run(request);
}

}  // namespace

TEST_CASE("the experiment's figures are inside their bands and the same on one and two jobs", "[unit]") {
  const auto one = reportOf({{"captures", "2"}}, 1), two = reportOf({{"captures", "2"}}, 2);
  REQUIRE(one);
  REQUIRE(two);
  std::set<std::string> ids;
  for (const PaperFigure& figure : one->figures) {
    CAPTURE(figure.id, figure.ours, figure.low, figure.high);
    CHECK(figure.inside());
    CHECK(ids.insert(figure.id).second);
  }
  CHECK(ids.count("table-5-radius-0.3") == 1);
  CHECK(ids.count("capture-gap") == 1);
  const ExperimentRequest request;
  CHECK(experimentJson(*one, request) == experimentJson(*two, request));
  CHECK(one->charts.size() >= 3);
  for (const ReportScene& scene : one->scenes) {
    for (const PageRow& row : scene.page.rows) REQUIRE(row.poses.size() == scene.page.bodies.size());
  }
}

TEST_CASE("the experiment refuses settings that make no sense by name", "[unit]") {
  CHECK(reportOf({{"gap", "x"}}, 1).error().message.find("'gap'") != std::string::npos);
  CHECK(reportOf({{"captures", "-1"}}, 1).error().code == ErrorCode::kUsage);
  CHECK(reportOf({{"captures", "0"}, {"gap", "1"}}, 1).error().message.find("gap") != std::string::npos);
}

TEST_CASE("more sightings and less noise make a better estimate", "[unit]") {
  const auto rows = capture::studyEstimators(3, 200);
  REQUIRE(rows.size() == 15);
  for (std::size_t level = 0; level < 3; ++level) {
    const auto* const first = &rows[5 * level];
    CHECK(first[1].heading == Approx(first[0].heading).epsilon(0.2));  // the triangle is the same formula
    CHECK(first[3].speed < first[0].speed);
    CHECK(first[4].speed < 0.4 * first[3].speed);
    CHECK(first[4].heading < first[0].heading);
  }
  CHECK(rows[14].position > rows[4].position);
}

}  // namespace fulbito
