#include "strategies/skills/shot_geometry.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

/// Distance [m] from `p` to the segment from `a` to `b`.
double distanceTo(Vec2 p, Vec2 a, Vec2 b) {
  const double share = std::clamp(dot(p - a, b - a) / squaredNorm(b - a), 0.0, 1.0);
  return distance(p, a + (b - a) * share);
}

}  // namespace

TEST_CASE("free intervals are where a ball passes all blockers", "[unit]") {
  const MatchInfo info = test::matchInfo();
  ShotModel model;
  model.acceleration = 0.0;  // blockers do not move
  Rng rng(7, test::kTestStream);
  int free = 0, taken = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec2 ball{rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6)};
    std::array<ShotBlocker, 3> blockers;
    for (ShotBlocker& blocker : blockers) {
      do {
        blocker.position = {rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)};
      } while (distance(blocker.position, ball) < 0.07);
    }
    const FreeMouth mouth(info.field, model, ball, blockers);
    const double half = info.field.goal_width / 2 - model.ball_radius;
    for (double y = -half + 0.001; y < half; y += 0.01) {
      const Vec2 target{info.field.length / 2, y};
      double gap = 1.0;
      for (const ShotBlocker& blocker : blockers) {
        if (blocker.position.x > ball.x) {
          gap =
              std::min(gap, distanceTo(blocker.position, ball, target) - blocker.radius - model.ball_radius);
        }
      }
      bool listed = false;
      for (const MouthInterval& interval : mouth.intervals()) listed |= y > interval.low && y < interval.high;
      if (std::abs(gap) > 0.002) {
        CAPTURE(i, y, gap);
        CHECK(listed == (gap > 0.0));
        (listed ? free : taken)++;
      }
    }
  }
  CHECK(free > 1000);
  CHECK(taken > 1000);
}

TEST_CASE("the best shot is into the widest interval, away from the keeper", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const ShotBlocker keeper{{0.7, 0.05}, 0.0375, {}};
  ShotModel model;
  model.acceleration = 0.5;
  const auto shot = bestShot(info.field, model, {0.3, 0.0}, {&keeper, 1});
  REQUIRE(shot);
  CHECK(shot->y < -0.05);
  ShotBlocker moving = keeper;
  moving.velocity = {0.0, -0.5};
  CHECK(bestShot(info.field, model, {0.3, 0.0}, {&moving, 1})->y > shot->y);
  // A wall of robots leaves no gap.
  const std::array<ShotBlocker, 3> wall = {
      {{{0.7, 0.0}, 0.04, {}}, {{0.7, 0.1}, 0.04, {}}, {{0.7, -0.1}, 0.04, {}}}};
  CHECK_FALSE(bestShot(info.field, {}, {0.3, 0.0}, wall));
}

}  // namespace fulbito
