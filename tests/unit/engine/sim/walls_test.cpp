#include "engine/sim/walls.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;

namespace {

bool contains(const WallOutline& wall, Vec2 p, double margin) {
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 a = wall[i], b = wall[(i + 1) % 4];
    if (cross(unitOr(b - a, {}), p - a) < margin) return false;
  }
  return true;
}

bool inAnyWall(const std::vector<WallOutline>& walls, Vec2 p, double margin) {
  for (const WallOutline& wall : walls) {
    if (contains(wall, p, margin)) return true;
  }
  return false;
}

std::vector<FieldGeometry> fields() {
  FieldGeometry plain{.goal_width = 0.0, .corner = 0.0};
  FieldGeometry tight{.length = 0.8, .width = 0.6, .goal_width = 0.4, .goal_depth = 0.03, .corner = 0.1};
  return {FieldGeometry{}, plain, tight};
}

}  // namespace

TEST_CASE("wall outlines are convex and counter-clockwise", "[unit]") {
  for (const FieldGeometry& field : fields()) {
    const auto walls = wallOutlines(field, 0.00075);
    for (const WallOutline& wall : walls) {
      for (std::size_t i = 0; i < 4; ++i) {
        const Vec2 a = wall[i], b = wall[(i + 1) % 4], c = wall[(i + 2) % 4];
        CHECK(cross(b - a, c - b) > 0.0);
      }
    }
  }
  CHECK(wallOutlines(FieldGeometry{}, 0.0).size() == 16);
  // Where the goal's posts meet the corner triangles, nothing is left of the end walls.
  CHECK(wallOutlines(fields()[2], 0.0).size() == 12);
}

TEST_CASE("walls leave the field free and close it all around", "[unit]") {
  for (const FieldGeometry& field : fields()) {
    const auto walls = wallOutlines(field, 0.0);
    Rng rng(3, test::kTestStream);
    int inside = 0, wrong = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec2 p{rng.uniform(-1.0, 1.0) * (field.length / 2 + field.goal_depth + 0.02),
                   rng.uniform(-1.0, 1.0) * (field.width / 2 + 0.02)};
      // Corners cut by 1e-6 exclude points that rounding decides.
      if (insideField(field, p, 1e-6)) {
        ++inside;
        if (inAnyWall(walls, p, 1e-9)) ++wrong;
      }
    }
    CHECK(inside > 5000);
    CHECK(wrong == 0);

    // A path along the contour, a centimetre outside it, never leaves the walls.
    const std::vector<Vec2> contour = innerContour(field);
    int open = 0;
    for (std::size_t i = 0; i < contour.size(); ++i) {
      const Vec2 a = contour[i], b = contour[(i + 1) % contour.size()];
      if (distance(a, b) < 1e-3) continue;
      const Vec2 out = -perp(unitOr(b - a, {})) * 0.01;
      for (int k = 0; k <= 200; ++k) {
        if (!inAnyWall(walls, a + (b - a) * (k / 200.0) + out, -1e-9)) ++open;
      }
    }
    CHECK(open == 0);
  }
}

TEST_CASE("where walls overlap at a goal post, only faces that look into the field push", "[unit]") {
  const auto walls = wallOutlines(FieldGeometry{}, 0.0);
  int end_walls = 0, goal_sides = 0;
  for (const WallOutline& wall : walls) {
    const Vec2 in = inward(wall);
    CHECK(norm(in) == Approx(1.0));
    CHECK(dot(in, wall[1] - wall[0]) < 0.0);  // the wall lies on the other side of its face
    CHECK(pushesInward(in, in));
    CHECK_FALSE(pushesInward(in, in * -1.0));
    const Vec2 middle = (wall[0] + wall[3]) / 2;
    end_walls += std::abs(std::abs(middle.x) - 0.75) < 1e-9 && std::abs(in.x) > 0.99 ? 1 : 0;
    goal_sides += std::abs(middle.x) > 0.76 && std::abs(in.y) > 0.99 ? 1 : 0;
  }
  CHECK(end_walls == 4);
  CHECK(goal_sides == 4);
  // The upper side wall of the left goal faces down. Its end pushes along the end wall's face; its back does
  // not push.
  CHECK(pushesInward({0.0, -1.0}, {1.0, 0.0}));
  CHECK_FALSE(pushesInward({0.0, -1.0}, {0.0, 1.0}));
}

TEST_CASE("shifted walls lie further out by just that much", "[unit]") {
  const auto walls = wallOutlines(FieldGeometry{}, 0.002);
  CHECK_FALSE(inAnyWall(walls, {0.0, 0.6519}, 0.0));
  CHECK(inAnyWall(walls, {0.0, 0.6521}, 0.0));
  CHECK_FALSE(inAnyWall(walls, {0.8519, 0.0}, 0.0));
  CHECK(inAnyWall(walls, {0.8521, 0.0}, 0.0));
  CHECK(inAnyWall(walls, {0.0, 0.7019}, 0.0));
  CHECK_FALSE(inAnyWall(walls, {0.0, 0.7021}, 0.0));
}
