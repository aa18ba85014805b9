#include "navigation/methods/paths/tangent_graph_search.hpp"

#include <algorithm>
#include <limits>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/polygon_oracle.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

double shortest(Vec2 a, Vec2 b, const std::vector<Circle>& circles) {
  TangentGraph graph;
  return graph.search(a, b, circles) ? graph.length() : -1.0;
}

double polylineLength(const std::vector<Vec2>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i) length += distance(points[i - 1], points[i]);
  return length;
}

double clearance(const std::vector<Vec2>& points, const std::vector<Circle>& circles) {
  double least = 1e9;
  for (const Circle& c : circles) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      least = std::min(least, test::segmentDistance(points[i - 1], points[i], c.centre) - c.radius);
    }
  }
  return least;
}

std::vector<Circle> randomCircles(Rng& rng, std::size_t count, double least, double most) {
  std::vector<Circle> circles;
  for (std::size_t i = 0; i < count; ++i) {
    circles.push_back({{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)}, rng.uniform(least, most)});
  }
  return circles;
}

/// Whether no two edges nearly touch and no point is near an edge. Otherwise the last digits of the reference
/// solution decide.
bool clearCut(const std::vector<Circle>& circles, Vec2 a, Vec2 b) {
  const double band = 1e-3;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    for (Vec2 p : {a, b}) {
      if (distance(circles[i].centre, p) < circles[i].radius + band) return false;
    }
    for (std::size_t k = 0; k < i; ++k) {
      const double gap =
          distance(circles[i].centre, circles[k].centre) - circles[i].radius - circles[k].radius;
      if (std::abs(gap) < band) return false;
    }
    const Vec2 c = circles[i].centre;
    for (double room : {0.75 - std::abs(c.x), 0.65 - std::abs(c.y),
                        (1.40 - 0.07 - std::abs(c.x) - std::abs(c.y)) * std::sqrt(0.5)}) {
      if (std::abs(room - 0.053 - circles[i].radius) < band) return false;
    }
  }
  return true;
}

}  // namespace

TEST_CASE("without discs in the way the shortest path is straight", "[unit]") {
  TangentGraph graph;
  REQUIRE(graph.search({0.0, 0.0}, {3.0, 4.0}, std::vector<Circle>{{{5.0, -5.0}, 1.0}}));
  CHECK(graph.length() == Approx(5.0));
  CHECK(graph.passes().empty());
}

TEST_CASE("the way round one disc is two tangents and an arc", "[unit]") {
  // Symmetric about the disc: 2 sqrt(d^2 - r^2) + r (pi - 2 acos(r / d)).
  const double d = 1.0, r = 0.4;
  const double expected = 2.0 * std::sqrt(d * d - r * r) + r * (math::kPi - 2.0 * std::acos(r / d));
  CHECK(shortest({-d, 0.0}, {d, 0.0}, {{{0.0, 0.0}, r}}) == Approx(expected).epsilon(1e-12));
  // Off the axis the path takes the shorter side.
  TangentGraph graph;
  REQUIRE(graph.search({-1.0, 0.0}, {1.0, 0.0}, std::vector<Circle>{{{0.0, -0.1}, r}}));
  REQUIRE(graph.passes().size() == 1);
  CHECK(graph.passes()[0].side == -1);  // passes above the disc: clockwise, with the disc on the right
  CHECK(graph.passes()[0].sweep > 0.0);
  CHECK(distance(graph.passes()[0].entry, {0.0, -0.1}) == Approx(r));
}

TEST_CASE("the way between two discs is a crossed belt", "[unit]") {
  // Discs above and below the axis force an S. The inner tangent of equal radii has the length sqrt(D^2 - 4
  // r^2).
  const double r = 0.3;
  const Vec2 below{-1.0, -0.2}, above{1.0, 0.2}, a{-2.0, -0.2}, b{2.0, 0.2};
  const double apart = distance(below, above), inner = std::sqrt(apart * apart - 4.0 * r * r);
  const double tangent = std::sqrt(1.0 - r * r);
  const double first = std::acos(r);                   // between the spoke to `a` and the one to the entry
  const double crossing = std::acos(2.0 * r / apart);  // between the centre line and the spoke to the exit
  const double line = std::atan2(0.4, 2.0);
  const double sweep = math::kPi - first - (crossing + line);
  const double s_path = 2.0 * tangent + inner + 2.0 * r * sweep;
  CHECK(shortest(a, b, {{below, r}, {above, r}}) == Approx(s_path).epsilon(1e-12));
}

TEST_CASE("overlapping discs are passed as one", "[unit]") {
  // Three equal, overlapping discs form a wall across the way. The path leads over the uppermost one.
  const double r = 0.3;
  const std::vector<Circle> wall{{{0.0, -0.5}, r}, {{0.0, 0.0}, r}, {{0.0, 0.4}, r}};
  const double d = std::sqrt(1.0 + 0.16);
  const double sweep = 2.0 * (math::kPi / 2 - std::acos(r / d) + std::atan2(0.4, 1.0));
  CHECK(shortest({-1.0, 0.0}, {1.0, 0.0}, wall) ==
        Approx(2.0 * std::sqrt(d * d - r * r) + r * sweep).epsilon(1e-12));
  TangentGraph graph;
  REQUIRE(graph.search({-1.0, 0.0}, {1.0, 0.0}, wall));
  REQUIRE(graph.passes().size() == 1);
  CHECK(graph.passes()[0].circle == 2);
}

TEST_CASE("a closed ring leaves no path, and one more circle of memory does not open it", "[unit]") {
  std::vector<Circle> ring;
  for (int i = 0; i < 12; ++i) ring.push_back({math::unit(i * math::kPi / 6) * 0.5, 0.14});
  TangentGraph graph;
  CHECK_FALSE(graph.search({0.0, 0.0}, {1.0, 0.0}, ring));
  CHECK(graph.length() == std::numeric_limits<double>::infinity());
  std::vector<Vec2> points{{1.0, 1.0}};
  graph.sample(0.01, points);
  CHECK(points.empty());
  ring.pop_back();
  CHECK(graph.search({0.0, 0.0}, {1.0, 0.0}, ring));
}

TEST_CASE("a disc that holds the start or the goal is shrunk to its edge", "[unit]") {
  const Circle disc{{0.0, 0.0}, 0.5};
  TangentGraph graph;
  REQUIRE(graph.search({-0.3, 0.0}, {1.0, 0.0}, std::vector<Circle>{disc}));
  const double r = 0.3, expected = r * (math::kPi - std::acos(r)) + std::sqrt(1.0 - r * r);
  CHECK(graph.length() == Approx(expected).epsilon(1e-5));
  REQUIRE(graph.passes().size() == 1);
  CHECK(graph.passes()[0].radius == Approx(0.3));
  // A start at the centre shrinks the disc to nothing.
  REQUIRE(graph.search({0.0, 0.0}, {1.0, 0.0}, std::vector<Circle>{disc}));
  CHECK(graph.length() == Approx(1.0));
}

TEST_CASE("walls exclude the side that is too narrow", "[unit]") {
  const FieldGeometry field;
  // The gap between the disc and the upper wall is less than the margin, although that way is shorter.
  const std::vector<Circle> circles{{{0.0, 0.45}, 0.16}};
  TangentGraph graph;
  REQUIRE(graph.search({-0.5, 0.5}, {0.5, 0.5}, circles));
  CHECK(graph.passes()[0].side == -1);
  REQUIRE(graph.search({-0.5, 0.5}, {0.5, 0.5}, circles, &field, 0.053));
  CHECK(graph.passes()[0].side == 1);
  std::vector<Circle> gate{circles[0], {{0.0, -0.1}, 0.40}, {{0.0, -0.5}, 0.15}};
  CHECK_FALSE(graph.search({-0.5, 0.5}, {0.5, 0.5}, gate, &field, 0.053));
  // A start at a wall moves only that wall out.
  REQUIRE(graph.search({-0.7, 0.61}, {0.5, 0.5}, circles, &field, 0.053));
  CHECK(graph.passes()[0].side == -1);
}

TEST_CASE("a preferred side is kept until the other is shorter by the penalty", "[unit]") {
  TangentGraph graph;
  const CirclePass above{0, -1, 0.0, {}, {}, 0.0};
  const auto side = [&](double offset) {
    const std::vector<Circle> circles{{{0.0, offset}, 0.3}};
    REQUIRE(graph.search({-1.0, 0.0}, {1.0, 0.0}, circles, nullptr, 0.0, {{&above, 1}, 0.05}));
    return graph.passes()[0].side;
  };
  CHECK(side(-0.02) == -1);
  CHECK(side(0.02) == -1);
  CHECK(side(0.2) == 1);
}

TEST_CASE("the shortest path agrees with a polygon visibility graph", "[unit][repeated]") {
  const FieldGeometry field;
  Rng rng(20, test::kTestStream);
  TangentGraph graph;
  std::vector<Vec2> points;
  const int scenes = 200 * test::repetitions();
  int solved = 0, closed = 0, bent = 0;
  double worst = 0.0;
  while (solved + closed < scenes) {
    const bool walls = rng.below(2) == 1;
    const std::vector<Circle> circles = randomCircles(rng, 4 + rng.below(9), 0.08, 0.22);
    const Vec2 a{rng.uniform(-0.69, -0.4), rng.uniform(-0.59, 0.59)};
    const Vec2 b{rng.uniform(0.4, 0.69), rng.uniform(-0.59, 0.59)};
    if (!clearCut(circles, a, b)) continue;
    if (wallClearance(field, a) < 0.055 || wallClearance(field, b) < 0.055) continue;
    const auto* bounds = walls ? &field : nullptr;
    const double expected = test::polygonShortestPath(a, b, circles, bounds, 0.053);
    const bool found = graph.search(a, b, circles, bounds, 0.053);
    REQUIRE(found == (expected < 1e9));
    if (!found) {
      ++closed;
      continue;
    }
    ++solved;
    if (graph.passes().size() >= 2) ++bent;
    worst = std::max(worst, std::abs(graph.length() / expected - 1.0));
    REQUIRE(graph.length() == Approx(expected).epsilon(1e-3));
    graph.sample(0.002, points);
    REQUIRE(points.front() == a);
    REQUIRE(points.back() == b);
    REQUIRE(polylineLength(points) == Approx(graph.length()).epsilon(1e-4));
    REQUIRE(clearance(points, circles) > -2e-5);
    for (Vec2 p : points) {
      if (walls) REQUIRE(wallClearance(field, p) > 0.053 - 1e-8);
    }
    // The way back has the same length.
    REQUIRE(graph.search(b, a, circles, bounds, 0.053));
    REQUIRE(graph.length() == Approx(polylineLength(points)).epsilon(1e-4));
  }
  CHECK(solved > scenes * 3 / 5);
  CHECK(bent > scenes / 5);
  CHECK(closed > 0);
  INFO("worst relative difference " << worst);
  CHECK(worst < 1e-3);
}

TEST_CASE("searching any of 64 overlapping discs ends and stays finite", "[unit]") {
  Rng rng(21, test::kTestStream);
  TangentGraph graph(64);
  for (int i = 0; i < 30; ++i) {
    const std::vector<Circle> circles = randomCircles(rng, 64, 0.0, 0.12);
    const Vec2 a{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)}, b = i % 5 == 0 ? a : Vec2{-a.y, a.x};
    if (!graph.search(a, b, circles, nullptr)) continue;
    CHECK(graph.length() >= distance(a, b) - 1e-12);
    CHECK(std::isfinite(graph.length()));
  }
}

}  // namespace fulbito
