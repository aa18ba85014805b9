#include "engine/core/models/field_places.hpp"

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {

TEST_CASE("places within the walls keep their room", "[unit]") {
  const FieldGeometry field;
  Rng rng(3, test::kTestStream);
  for (int i = 0; i < 1000; ++i) {
    const Vec2 p{rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    const Vec2 inside = insideWalls(field, p, 0.05);
    CHECK(wallClearance(field, inside) >= 0.05 - 1e-9);
    if (wallClearance(field, p) > 0.05) CHECK(inside == p);
  }
}

TEST_CASE("the equal-gap point leaves the same gap on both sides", "[unit]") {
  const FieldGeometry field;
  Rng rng(1, test::kTestStream);
  for (int i = 0; i < 200; ++i) {
    const Vec2 ball{rng.uniform(-0.6, 0.7), rng.uniform(-0.6, 0.6)};
    const Vec2 place = equalGapPoint(field, ball, 0.05);
    // Where the lines from the ball to the posts pass the keeper's line.
    const double share = (ball.x - place.x) / (ball.x + field.length / 2);
    const double up = ball.y + (field.goal_width / 2 - ball.y) * share;
    const double down = ball.y + (-field.goal_width / 2 - ball.y) * share;
    CHECK(up - place.y == Approx(place.y - down).margin(1e-9));
  }
}

}  // namespace fulbito
