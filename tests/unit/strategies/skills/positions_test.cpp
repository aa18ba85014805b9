#include "strategies/skills/positions.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/skills/area_projection.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {

TEST_CASE("the keeper goes where a ball will pass its line", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallCourse course(info.field, info.ball, info.physics);
  BallPrediction ball;
  const Vec2 shot = unitOr(Vec2{-0.75, 0.12} - Vec2{0.0, -0.3}, {}) * 1.2;
  ball.predict(course, {{0.0, -0.3}, shot, shot});
  const Vec2 place = keeperPoint(info.field, ball, 0.05, 0.17);
  CHECK(place.x == Approx(-0.70));
  CHECK(place.y == Approx(0.12).margin(0.04));
  // For a ball that moves away, the keeper waits at the equal-gap point.
  ball.predict(course, {{0.0, -0.3}, -shot, -shot});
  CHECK(keeperPoint(info.field, ball, 0.05, 0.17) == equalGapPoint(info.field, {0.0, -0.3}, 0.05));
}

TEST_CASE("places outside an area are outside, near and stay", "[unit]") {
  const FieldGeometry field = test::matchInfo().field;
  Rng rng(2, test::kTestStream);
  int moved = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 p{rng.uniform(-0.75, 0.75), rng.uniform(-0.65, 0.65)};
    const bool own = i % 2 == 0;
    const double margin = rng.uniform(0.0, 0.1);
    const Vec2 out = outsideArea(field, p, own, margin);
    CHECK_FALSE(isInArea(field, out, own, margin - 1e-9));
    CHECK(outsideArea(field, out, own, margin - 1e-9) == out);
    CHECK(isInArea(field, p, own, margin) == isInArea(field, -p, !own, margin));
    CHECK(outsideArea(field, -p, !own, margin) == -out);
    if (insideField(field, p)) CHECK(insideField(field, out, -1e-9));
    moved += out != p;
  }
  CHECK(moved > 150);
  // The arc in front of the area belongs to it.
  CHECK(isInArea(field, {-0.57, 0.0}, true));
  CHECK_FALSE(isInArea(field, {-0.57, 0.2}, true));
}

TEST_CASE("clearances go upfield to a side, clear of opponents", "[unit]") {
  const FieldGeometry field = test::matchInfo().field;
  Rng rng(4, test::kTestStream);
  for (int i = 0; i < 300; ++i) {
    const Vec2 ball{rng.uniform(-0.7, -0.3), rng.uniform(-0.6, 0.6)};
    const std::array<Vec2, 2> opponents = {
        {{rng.uniform(-0.5, 0.5), rng.uniform(-0.6, 0.6)}, {rng.uniform(-0.5, 0.5), rng.uniform(-0.6, 0.6)}}};
    const Vec2 way = clearanceTarget(field, ball, opponents) - ball;
    CHECK(way.x > 0.0);
    CHECK(way.y * ball.y >= 0.0);
    CHECK(math::atan2(way.x, std::abs(way.y)) > 0.52);  // 30 degrees off the goal line
  }
}

TEST_CASE("the shadow is between ball and goal and out of the own area", "[unit]") {
  const FieldGeometry field = test::matchInfo().field;
  Rng rng(5, test::kTestStream);
  for (int i = 0; i < 300; ++i) {
    const Vec2 ball{rng.uniform(-0.5, 0.7), rng.uniform(-0.6, 0.6)};
    const Vec2 place = shadowPoint(field, ball, rng.uniform(0.1, 0.8));
    CHECK(std::abs(cross(place - ball, ownGoal(field) - ball)) < 1e-9);
    CHECK(place.x <= ball.x + 1e-12);
    CHECK(place.x >= -field.length / 2 + field.goal_area_depth - 1e-12);
  }
  CHECK(reboundSpot(field, {0.5, 0.3}).y < 0.0);
}

}  // namespace fulbito
