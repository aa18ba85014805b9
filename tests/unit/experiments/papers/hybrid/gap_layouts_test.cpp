#include "experiments/papers/hybrid/gap_layouts.hpp"

#include <algorithm>

#include "experiments/papers/hybrid/hybrid_runs.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::hybrid {

TEST_CASE("every kind of gap has one gap of that width, and no other that a robot passes", "[unit]") {
  for (GapKind kind : kGapKinds) {
    for (std::uint64_t i = 0; i < 40; ++i) {
      const Layout layout = gapOfKind(kind, 5, i, 1.3);
      CHECK(validate(layout));
      REQUIRE(layout.obstacles.size() >= 2);
      CHECK(distanceBetween(layout.obstacles[0], layout.obstacles[1]) == Approx(1.3 * 0.075));
      for (const ObstacleSpec& body : layout.obstacles) {
        const bool at_end = std::abs(body.pose.position.y) > 0.5;
        double nearest = 1e9;
        for (const ObstacleSpec& other : layout.obstacles) {
          if (&other != &body) nearest = std::min(nearest, distanceBetween(body, other));
        }
        CHECK((at_end || nearest < 1.31 * 0.075));
      }
    }
  }
}

TEST_CASE("the kinds differ, and a layout is a function of seed and index", "[unit]") {
  CHECK(gapOfKind(GapKind::kDiscs, 5, 3, 1.3).obstacles[0].radius ==
        gapOfKind(GapKind::kDiscs, 5, 3, 1.3).obstacles[0].radius);
  double least = 1.0, most = 0.0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    const double radius = gapOfKind(GapKind::kDiscs, 6, i, 1.3).obstacles[0].radius;
    least = std::min(least, radius), most = std::max(most, radius);
  }
  CHECK(least < 0.02);
  CHECK(most > 0.095);
  CHECK(gapOfKind(GapKind::kDoorway, 5, 3, 1.3).obstacles.size() == 2);
  CHECK(gapOfKind(GapKind::kBoxes, 5, 3, 1.3).obstacles[0].shape == ObstacleShape::kBox);
}

TEST_CASE("a sample of all kinds of gaps is taken by sonars only", "[unit]") {
  int through = 0, touched = 0;
  for (GapKind kind : kGapKinds) {
    for (std::uint64_t i = 0; i < 2; ++i) {
      const auto config = sonarTrial(gapOfKind(kind, 61, i, 1.3), Knowledge::kSonars, "hybrid", 0.3, 61, i);
      REQUIRE(config);
      const auto result = runTrial(*config, {});
      REQUIRE(result);
      through += result->score.success() ? 1 : 0;
      touched += result->score.obstacle_contacts + result->score.wall_contacts > 0 ? 1 : 0;
    }
  }
  CHECK(through >= 6);
  CHECK(touched <= 1);
}

}  // namespace fulbito::hybrid
