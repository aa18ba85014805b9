#include <algorithm>

#include "experiments/papers/hybrid/hybrid_runs.hpp"
#include "experiments/papers/hybrid/hybrid_scenes.hpp"
#include "experiments/papers/paper_experiments.hpp"
#include "experiments/trials/suite_layouts.hpp"
#include "fulbito/report.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

ExperimentRequest request(int jobs) {
  ExperimentRequest request;
  request.seed = 5;
  request.jobs = jobs;
  request.settings = {{"rows", "3"}, {"gaps", "2"}, {"kinds", "1"}};
  return request;
}

double figure(const ExperimentReport& report, const std::string& id) {
  const auto found = std::find_if(report.figures.begin(), report.figures.end(),
                                  [&](const PaperFigure& f) { return f.id == id; });
  REQUIRE(found != report.figures.end());
  return found->ours;
}

}  // namespace

TEST_CASE("experiment hybrid: the same bytes on one and two threads; rows are shorter with the diagram",
          "[unit]") {
  const auto one = (*findPaperExperiment(paperExperiments(), "hybrid"))->run(request(1)),
             two = (*findPaperExperiment(paperExperiments(), "hybrid"))->run(request(2));
  REQUIRE(one);
  REQUIRE(two);
  CHECK(experimentJson(*one, request(1)) == experimentJson(*two, request(1)));
  CHECK(figure(*one, "row-shorter") >= 80.0);
  CHECK(figure(*one, "row-length-ratio") < 0.9);
  CHECK(figure(*one, "row-direct-ratio") < 1.0);
  CHECK(figure(*one, "gap-1.6-sonars") == 100.0);
  CHECK(figure(*one, "gap-1.3-sonars") == 100.0);
  CHECK(figure(*one, "gap-1.3-sonars-contact") == 0.0);
  CHECK(figure(*one, "gap-1.3-map") == 100.0);
  CHECK(figure(*one, "gap-1.3-map-contact") == 0.0);
}

TEST_CASE("experiment hybrid: a wrong setting is named", "[unit]") {
  ExperimentRequest wrong;
  wrong.settings = {{"speed", "9"}};
  const auto result = (*findPaperExperiment(paperExperiments(), "hybrid"))->run(wrong);
  REQUIRE_FALSE(result);
  CHECK(result.error().message.find("speed") != std::string::npos);
}

TEST_CASE("gap layouts have a gap of exactly that width, rows have ways round both ends", "[unit]") {
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Layout gap = gapLayout(9, i, 1.3), row = rowLayout(9, i, 1.4);
    int gaps = 0, open = 0;
    for (const ObstacleSpec& a : gap.obstacles) {
      for (const ObstacleSpec& b : gap.obstacles) {
        const double between = distance(a.pose.position, b.pose.position) - a.radius - b.radius;
        gaps += std::abs(between - 1.3 * 0.075) < 1e-9 ? 1 : 0;
      }
    }
    CHECK(gaps == 2);  // each pair is met twice
    for (const ObstacleSpec& o : row.obstacles) {
      const double end = 0.65 - std::abs(o.pose.position.y) - o.radius;
      open += end < 0.40 - 1e-9 ? 1 : 0;
    }
    CHECK(open == 0);
  }
}

TEST_CASE("a scene of the hybrid shows the cones that its caption promises, and its title once", "[unit]") {
  const auto scene = hybrid::hybridScene("gap", "A gap", gapLayout(31, 2, 1.6), 0.3, 31, 2, false);
  REQUIRE(scene);
  CHECK(scene->caption.find("A gap") == std::string::npos);
  REQUIRE(scene->moments.size() == 1);
  const Tick shown = scene->page.rows[scene->moments.front().row].tick;
  const auto cones = std::count_if(
      scene->page.drawings.begin(), scene->page.drawings.end(),
      [&](const auto& d) { return d.tick <= shown && d.tick > shown - scene->page.drawing_ticks; });
  CHECK(cones >= 3);  // lines of at least one cone
}

}  // namespace fulbito
