#include "strategies/skills/shot_geometry.hpp"

#include <cmath>

#include "engine/core/math/math.hpp"
#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

/// Distance [m] from `p` to the stretch from `a` to `b`.
double distanceTo(Vec2 p, Vec2 a, Vec2 b) {
  const double share = std::clamp(dot(p - a, b - a) / squaredNorm(b - a), 0.0, 1.0);
  return distance(p, a + (b - a) * share);
}

}  // namespace

TEST_CASE("free intervals are where a ball passes all blockers", "[unit]") {
  const MatchInfo info = test::matchInfo();
  ShotModel model;
  model.acceleration = 0.0;  // nobody moves
  Rng rng(7, Stream::kTest);
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
  CHECK(shot->aim.y < -0.05);
  CHECK(shot->probability > 0.0);
  CHECK(shot->probability < bestShot(info.field, model, {0.3, 0.0}, {})->probability);
  ShotBlocker moving = keeper;
  moving.velocity = {0.0, -0.5};
  CHECK(bestShot(info.field, model, {0.3, 0.0}, {&moving, 1})->aim.y > shot->aim.y);
  // A wall of robots leaves nothing.
  const std::array<ShotBlocker, 3> wall = {
      {{{0.7, 0.0}, 0.04, {}}, {{0.7, 0.1}, 0.04, {}}, {{0.7, -0.1}, 0.04, {}}}};
  CHECK_FALSE(bestShot(info.field, {}, {0.3, 0.0}, wall));
}

TEST_CASE("the chance of a goal is the normal distribution's", "[unit]") {
  for (double angle = 0.0; angle < 0.5; angle += 0.01) {
    CHECK(chanceWithin(angle, 0.07) == Approx(std::erf(angle / (0.07 * std::sqrt(2.0)))).margin(1e-6));
  }
}

TEST_CASE("a bank shot comes to its target by the prediction", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallCourse course(info.field, info.ball, info.physics);
  Rng rng(9, Stream::kTest);
  int found = 0;
  for (int i = 0; i < 200; ++i) {
    // A wall leaves the ball a quarter of the speed toward it: it comes back 0.3 m at most, never as far as
    // the goal mouth.
    const bool upper = i % 2 == 0;
    const double side = upper ? 1.0 : -1.0;
    const Vec2 ball{rng.uniform(-0.5, 0.1), side * rng.uniform(0.1, 0.4)};
    const Vec2 target{ball.x + rng.uniform(0.2, 0.5), side * rng.uniform(0.40, 0.55)};
    const auto shot = bankShot(course, info.field, ball, target, upper, 1.2);
    if (!shot) continue;
    ++found;
    CHECK(norm(shot->direction) == Approx(1.0));
    CHECK((shot->direction.y > 0.0) == upper);
    CHECK(shot->miss < 0.02);
    CHECK(std::abs(shot->bounce.y) == Approx(info.field.width / 2 - info.ball.radius).margin(1e-6));
  }
  CHECK(found > 100);
}

}  // namespace fulbito
