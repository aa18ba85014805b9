#pragma once

#include "fulbito/detail/math.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/draws.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito::test {

/// Whether a disc keeps `gap` [m] from all discs of the layout and `keep` from its start and goal.
inline bool fits(const CornerLayout& layout, Vec2 centre, double radius, double gap, double keep) {
  for (const DiscObstacle& o : layout.obstacles) {
    if (distance(centre, o.position) < radius + o.radius + gap) return false;
  }
  return distance(centre, layout.start.position) > radius + keep &&
         distance(centre, layout.goal.position) > radius + keep;
}

/// A short run of 0.55 to 0.75 m, start and goal anywhere free, past the corner layout's four balls.
inline CornerLayout shortLayout(std::uint64_t seed) {
  Rng rng(seed, kTestStream, 2);
  CornerLayout layout = cornerLayout(seed + 5000);
  const Vec2 middle = (layout.obstacles[0].position + layout.obstacles[1].position) / 2;
  for (;;) {
    const double angle = rng.uniform(-math::kPi, math::kPi), length = rng.uniform(0.55, 0.75);
    const Vec2 centre = middle + Vec2{rng.uniform(-0.2, 0.2), rng.uniform(-0.2, 0.2)};
    layout.start = {centre - math::unit(angle) * (length / 2), angle};
    layout.goal.position = centre + math::unit(angle) * (length / 2);
    bool free = true;
    for (const DiscObstacle& o : layout.obstacles) {
      if (distance(o.position, layout.start.position) < 0.1 ||
          distance(o.position, layout.goal.position) < 0.1)
        free = false;
    }
    for (Vec2 p : {layout.start.position, layout.goal.position}) {
      if (wallClearance(FieldGeometry{}, p) < 0.07) free = false;
    }
    if (free) return layout;
  }
}

/// The corner layout with a start and an arrival heading anywhere on the circle.
inline CornerLayout headingLayout(std::uint64_t seed) {
  Rng rng(seed, kTestStream, 3);
  CornerLayout layout = cornerLayout(seed + 9000);
  layout.start.heading = rng.uniform(-math::kPi, math::kPi);
  layout.goal.heading = rng.uniform(-math::kPi, math::kPi);
  return layout;
}

/// Goals where it is tight: near a wall, in a corner, within 2 cm of a disc inflated by the circumscribed
/// circle.
inline CornerLayout wallLayout(std::uint64_t seed) {
  Rng rng(seed, kTestStream, 4);
  CornerLayout layout = cornerLayout(seed + 13000);
  const int kind = static_cast<int>(rng.below(3));
  layout.start.heading = rng.uniform(-math::kPi, math::kPi);
  if (kind == 0) layout.goal.position = {0.75 - 0.0550, rng.uniform(-0.5, 0.5)};
  if (kind == 1)
    layout.goal.position = {0.75 - rng.uniform(0.06, 0.08), 0.65 - rng.uniform(0.06, 0.08) - 0.03};
  if (kind == 2) {
    for (;;) {
      const DiscObstacle& o = layout.obstacles[rng.below(4)];
      layout.goal.position = o.position + math::unit(rng.uniform(-math::kPi, math::kPi)) *
                                              (o.radius + 0.053 + rng.uniform(0.0, 0.02));
      bool free = true;
      for (const DiscObstacle& other : layout.obstacles) {
        if (distance(other.position, layout.goal.position) < other.radius + 0.053) free = false;
      }
      if (free) break;
    }
  }
  return layout;
}

/// A wall of discs across the whole field with one gap of the given width, and up to three loose discs.
inline CornerLayout gapLayout(std::uint64_t seed, double gap) {
  Rng rng(seed, kTestStream, 5);
  CornerLayout layout;
  const double x = rng.uniform(-0.2, 0.2), y = rng.uniform(-0.35, 0.35), tilt = rng.uniform(-0.5, 0.5);
  const Vec2 along = math::unit(math::kPi / 2 + tilt);
  layout.start = {{-0.60, rng.uniform(-0.4, 0.4)}, 0.0};
  layout.goal.position = {0.60, rng.uniform(-0.4, 0.4)};
  for (const double side : {-1.0, 1.0}) {
    double way = gap / 2;
    while (insideField(FieldGeometry{}, Vec2{x, y} + along * (side * (way + 0.053)), 0.0)) {
      const double radius = rng.uniform(0.0375, 0.053);
      layout.obstacles.push_back({Vec2{x, y} + along * (side * (way + radius)), radius, {}});
      way += 2.0 * radius + rng.uniform(0.0, 0.03);
    }
  }
  for (int i = static_cast<int>(rng.below(3)); i > 0; --i) {
    const Vec2 centre{rng.uniform(-0.6, 0.6), rng.uniform(-0.5, 0.5)};
    if (fits(layout, centre, 0.045, 0.14, 0.12)) layout.obstacles.push_back({centre, 0.045, {}});
  }
  layout.start.heading = math::angleOf(layout.goal.position - layout.start.position);
  return layout;
}

/// One to five robot-sized discs that cross at 0.3 to 1.5 m/s.
inline CornerLayout movingLayout(std::uint64_t seed) {
  Rng rng(seed, kTestStream, 6);
  CornerLayout layout = cornerLayout(seed);
  layout.obstacles.clear();
  const int discs = 1 + static_cast<int>(rng.below(5));
  while (static_cast<int>(layout.obstacles.size()) < discs) {
    const double radius = rng.uniform(0.0375, 0.053);
    const Vec2 centre{rng.uniform(-0.65, 0.65), rng.uniform(-0.55, 0.55)};
    if (!fits(layout, centre, radius, 0.05, 0.25)) continue;
    const Vec2 velocity = drawVector(rng, 0.3, 1.5);
    layout.obstacles.push_back({centre, radius, velocity});
  }
  return layout;
}

/// One to five robot-sized discs that cross a straight run along the field.
inline CornerLayout crossingLayout(std::uint64_t seed) {
  Rng rng(seed, kTestStream, 9);
  CornerLayout layout;
  layout.start = {{-0.63, 0.0}, 0.0};
  layout.goal.position = {0.63, 0.0};
  for (int i = 1 + static_cast<int>(rng.below(5)); i > 0; --i) {
    const double side = rng.below(2) == 0 ? 1.0 : -1.0;
    layout.obstacles.push_back({{rng.uniform(-0.4, 0.5), side * rng.uniform(0.3, 0.6)},
                                0.0375,
                                {rng.uniform(-0.2, 0.2), -side * rng.uniform(0.3, 1.0)}});
  }
  return layout;
}

}  // namespace fulbito::test
