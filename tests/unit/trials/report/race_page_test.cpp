#include "trials/report/race_page.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

Comparison compared(const std::string& suite, int pictures) {
  ComparisonConfig config;
  config.suite = suite;
  config.navigators = {"bezier", "straight"};
  config.speeds = {1.0};
  config.trials = 2;
  config.jobs = 1;
  config.pictures = pictures;
  auto comparison = planComparison(config);
  REQUIRE(comparison);
  REQUIRE(runComparison(*comparison, {}, {}));
  return std::move(*comparison);
}

}  // namespace

TEST_CASE("a race shows every navigator where it was", "[unit]") {
  const Comparison comparison = compared("moving", 1);
  const auto page = racePage(comparison);
  REQUIRE(page);
  CHECK(page->kind == PageKind::kRaces);
  REQUIRE(page->scenes.size() == 1);
  const PageScene& scene = page->scenes[0];
  REQUIRE(scene.runs.size() == 2);
  CHECK(scene.runs[1].label == "straight");
  Tick longest = 0;
  for (std::size_t n = 0; n < 2; ++n) {
    const TrialRecord& record = recordsOf(comparison, 0, n)[0];
    longest = std::max(longest, static_cast<Tick>(record.trace.size()) - 1);
    for (const PageRow& row : scene.rows) {
      const std::size_t last = std::min(static_cast<std::size_t>(row.tick), record.trace.size() - 1);
      CHECK(row.poses[n].position.x == record.trace[last].robot.pose.position.x);
      CHECK(row.poses[n].heading == record.trace[last].robot.pose.heading);
    }
    CHECK(scene.runs[n].seconds == record.score.time);
    CHECK(scene.runs[n].success == record.score.success());
  }
  CHECK(scene.ticks == longest);
  CHECK(scene.rows.back().tick == longest);
}

TEST_CASE("moving obstacles of a race move", "[unit]") {
  const Comparison comparison = compared("moving", 1);
  const auto page = racePage(comparison);
  REQUIRE(page);
  const PageScene& scene = page->scenes[0];
  const Layout layout = comparison.blocks[0].suite->layout(comparison.config.seed, 0);
  REQUIRE(scene.bodies.size() == 2 + layout.obstacles.size());
  double moved = 0.0;
  for (std::size_t i = 0; i < layout.obstacles.size(); ++i) {
    const Vec2 first = scene.rows.front().poses[2 + i].position, later = scene.rows[10].poses[2 + i].position;
    moved += distance(first, later);
    const Vec2 wanted =
        positionAt(layout.obstacles[i], static_cast<double>(scene.rows[10].tick) / scene.rate);
    CHECK(distance(later, wanted) == Approx(0.0).margin(1e-12));
  }
  CHECK(moved > 0.05);
}

TEST_CASE("a race needs ways that were kept", "[unit]") {
  const auto page = racePage(compared("corner", 0));
  REQUIRE_FALSE(page);
  CHECK(page.error().code == ErrorCode::kUsage);
  CHECK(page.error().message.find("--pictures") != std::string::npos);
}

}  // namespace fulbito
