#include "strategies/skills/area_projection.hpp"

#include "engine/core/math/random.hpp"
#include "engine/core/models/goal_area.hpp"
#include "fulbito/models.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {

TEST_CASE("points far from an area are told from near ones as by its shape", "[unit]") {
  for (const char* name : {"vsss-3v3", "vsss-5v5"}) {
    const FieldGeometry field = *loadField(name);
    const AreaShape area = goalAreaOf(field);
    Rng rng(3, test::kTestStream);
    for (int run = 0; run < 20000; ++run) {
      // Many points are at the area's front.
      const double margin = rng.uniform(0.0, 0.2), front = area.reach() + margin;
      const double ahead = run % 2 == 0 ? rng.uniform(-1e-9, 1e-9) : rng.uniform(-0.3, 0.3);
      const Vec2 seen{front + ahead, rng.uniform(-0.1, 0.1) * (run % 3)};
      const bool own = run % 4 < 2;
      const Side side = own ? Side::kLeft : Side::kRight;
      const Vec2 p = outOfGoalFrame(field, side, seen), again = intoGoalFrame(field, side, p);
      CAPTURE(name, seen, margin, own);
      REQUIRE(isInArea(field, p, own, margin) == contains(grown(area, margin), again));
      REQUIRE(isNearArea(field, p, own, margin) == (distanceToArea(field, p, own) < margin));
      if (!isInArea(field, p, own, margin)) REQUIRE(outsideArea(field, p, own, margin) == p);
    }
  }
}

}  // namespace fulbito
