#include "experiments/papers/hybrid/hybrid_runs.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::hybrid {
namespace {

/// What 500 runs of one kind reach at least and touch at most. docs/results/hybrid.md has the rates of 200
/// runs on another seed; the share of 500 runs lies outside of these bounds in one of a hundred samples, by
/// the binomial errors of both.
struct Bounds {
  GapKind kind;
  int through, touched;
};
constexpr Bounds kBounds[] = {{GapKind::kDiscs, 445, 33},
                              {GapKind::kBoxes, 422, 25},
                              {GapKind::kDoorway, 391, 44},
                              {GapKind::kMixed, 422, 37}};

}  // namespace

TEST_CASE("2000 gaps of all kinds: nearly all are taken, few are touched", "[soak]") {
  for (const Bounds& bounds : kBounds) {
    int through = 0, touched = 0;
    for (std::uint64_t i = 0; i < 500; ++i) {
      const auto config =
          sonarTrial(gapOfKind(bounds.kind, 7001, i, 1.3), Knowledge::kSonars, "hybrid", 0.3, 7001, i);
      REQUIRE(config);
      const auto result = runTrial(*config, {});
      REQUIRE(result);
      through += result->score.success() ? 1 : 0;
      touched += result->score.obstacle_contacts + result->score.wall_contacts > 0 ? 1 : 0;
    }
    INFO(nameOf(bounds.kind));
    CHECK(through >= bounds.through);
    CHECK(touched <= bounds.touched);
  }
}

}  // namespace fulbito::hybrid
