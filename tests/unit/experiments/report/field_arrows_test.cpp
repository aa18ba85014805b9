#include "experiments/report/field_arrows.hpp"

#include "experiments/comparison/comparison_parts.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/experiment.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

TrialConfig configFor(const std::string& navigator) {
  ComparisonConfig config;
  config.suite = "corner";
  config.trials = 1;
  config.navigators = {navigator};
  const auto comparison = planComparison(config);
  REQUIRE(comparison);
  return *trialConfig(*comparison, comparison->blocks.front(), 0, 0);
}

}  // namespace

TEST_CASE("arrows are what the field wants, on the field and outside of obstacles", "[unit]") {
  const TrialConfig config = configFor("vector-field:offset=0.1,width=0.05");
  const Vec2 low{-1.0, -0.8}, high{1.0, 0.8};
  const auto arrows = fieldArrows(config, low, high);
  REQUIRE(arrows);
  CHECK(arrows->size() > 400);
  for (const Pose2& arrow : *arrows) {
    CHECK(insideField(config.field, arrow.position));
    double nearest = 1e9;
    Vec2 centre;
    for (const ObstacleSpec& o : config.layout.obstacles) {
      const double off = distance(o.pose.position, arrow.position);
      if (off < nearest) nearest = off, centre = o.pose.position;
    }
    CHECK(nearest >= 0.0335);
    const Vec2 wanted = nearest < 0.1 ? arrow.position - centre : config.layout.goal - arrow.position;
    if (nearest > 0.1 && nearest < 0.15) continue;  // transition between the two fields
    CHECK(math::unit(arrow.heading).x == Approx(unitOr(wanted, {}).x).margin(1e-9));
  }
}

TEST_CASE("a method that is no field has no arrows", "[unit]") {
  CHECK(fieldArrows(configFor("bezier"), {-1, -1}, {1, 1})->empty());
  CHECK(fieldArrows(configFor("dwa"), {-1, -1}, {1, 1})->empty());
}

}  // namespace fulbito
