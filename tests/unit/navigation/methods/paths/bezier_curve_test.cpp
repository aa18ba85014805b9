#include "navigation/methods/paths/bezier_curve.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

constexpr double kDegree = 3.14159265358979323846 / 180.0;

}  // namespace

TEST_CASE("a Bezier curve of degree three has the textbook's points", "[unit]") {
  const std::array<Vec2, 4> control{Vec2{0.0, 0.0}, Vec2{0.0, 3.0}, Vec2{3.0, 3.0}, Vec2{3.0, 0.0}};
  BezierSamples points;
  sampleBezier(control, points);
  CHECK(points.front() == control.front());
  CHECK(points.back() == control.back());
  // B(1/4) = 27/64 P0 + 27/64 P1 + 9/64 P2 + 1/64 P3.
  CHECK(points[24].x == Approx(3.0 * (9.0 + 1.0) / 64.0));
  CHECK(points[24].y == Approx(3.0 * (27.0 + 9.0) / 64.0));
  CHECK(points[48].x == Approx(1.5));
  CHECK(points[48].y == Approx(2.25));
  CHECK(distance(bezierPoint(control, 24), points[24]) < 1e-15);
}

TEST_CASE("one obstacle bulges the curve by half the distance of its control point", "[unit]") {
  const Vec2 from{-0.5, 0.0}, to{0.5, 0.0};
  const std::array<Vec2, 3> control{from, controlPoint(from, {0.0, 0.0}, 1, 0.33), to};
  BezierSamples points;
  sampleBezier(control, points);
  CHECK(points[48].x == Approx(0.0).margin(1e-15));
  CHECK(points[48].y == Approx(0.165));
}

TEST_CASE("four obstacles on one side bulge the curve by 0.94 of that distance", "[unit]") {
  // At the middle of a curve of degree five each end has the weight 1/32, so the four inner control points
  // have 30/32.
  const Vec2 from{-0.5, 0.0}, to{0.5, 0.0};
  std::array<Vec2, 6> control{from, {}, {}, {}, {}, to};
  for (std::size_t i = 1; i <= 4; ++i) {
    control[i] = controlPoint(from, {-0.5 + 0.2 * static_cast<double>(i), 0.0}, 1, 0.33);
  }
  BezierSamples points;
  sampleBezier(control, points);
  double bulge = 0.0;
  for (Vec2 p : points) bulge = std::max(bulge, p.y);
  CHECK(bulge == Approx(0.9375 * 0.33));
}

TEST_CASE("a Bezier curve stays in the hull of its control points", "[unit]") {
  Rng rng(3, test::kTestStream);
  for (int round = 0; round < 100; ++round) {
    std::vector<Vec2> control(2 + rng.below(kBezierDegree));
    for (Vec2& p : control) p = {rng.uniform(-1.0, 1.0), rng.uniform(-1.0, 1.0)};
    BezierSamples points;
    sampleBezier(control, points);
    for (int i = 0; i < 24; ++i) {
      const Vec2 normal{std::cos(i * 15.0 * kDegree), std::sin(i * 15.0 * kDegree)};
      double most = -1e9;
      for (Vec2 p : control) most = std::max(most, dot(p, normal));
      for (Vec2 p : points) REQUIRE(dot(p, normal) <= most + 1e-12);
    }
  }
}

TEST_CASE("the segment AB stands across the line to the obstacle in every direction", "[unit]") {
  // With theta = pi - phi as printed, the angle would be 130, 170 and 180 degrees for phi = 20, 40 and 45.
  const Vec2 robot{0.2, -0.1};
  for (int degrees = 0; degrees < 360; degrees += 5) {
    const Vec2 line{std::cos(degrees * kDegree), std::sin(degrees * kDegree)};
    const Circle obstacle{robot + line * 0.7, 0.0335};
    const SafeEnds ends = safeEnds(robot, obstacle, 0.01);
    CHECK(dot(ends.a - ends.b, line) == Approx(0.0).margin(1e-12));
    CHECK(cross(line, ends.a - obstacle.centre) == Approx(3.0 * 0.0335 + 0.01));  // r is the radius
    CHECK(distance(ends.a, ends.b) == Approx(2.0 * (3.0 * 0.0335 + 0.01)));
    // The corrected phi = atan2(B - O) puts the control point on B's side, in all 36 directions and between
    // them.
    const Vec2 to_b = controlPoint(robot, obstacle.centre, -1, 0.33) - obstacle.centre;
    CHECK(norm(to_b) == Approx(0.33));
    CHECK(cross(to_b, ends.b - obstacle.centre) == Approx(0.0).margin(1e-12));
    CHECK(dot(to_b, ends.b - obstacle.centre) > 0.0);
  }
}

TEST_CASE("obstacles are selected whose segment AB the line crosses, in the order along it", "[unit]") {
  const Vec2 robot{-0.6, 0.0}, goal{0.6, 0.0};
  const std::vector<Circle> obstacles{
      {{0.3, 0.05}, 0.0335},    // on the line
      {{-0.2, -0.09}, 0.0335},  // still within 3 r = 10.05 cm
      {{0.0, 0.15}, 0.0335},    // too far beside it
      {{0.9, 0.0}, 0.0335},     // behind the goal
      {{-0.9, 0.0}, 0.0335},    // behind the robot
  };
  std::vector<std::size_t> selected;
  selectObstacles(robot, goal, obstacles, 0.0, selected);
  CHECK(selected == std::vector<std::size_t>{1, 0});
  selectObstacles(robot, goal, obstacles, 0.06, selected);
  CHECK(selected == std::vector<std::size_t>{1, 2, 0});
}

TEST_CASE("segments that only touch do not cross", "[unit]") {
  CHECK(properlyIntersect({0.0, 0.0}, {2.0, 0.0}, {1.0, -1.0}, {1.0, 1.0}));
  CHECK_FALSE(properlyIntersect({0.0, 0.0}, {2.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}));
  CHECK_FALSE(properlyIntersect({0.0, 0.0}, {2.0, 0.0}, {3.0, -1.0}, {3.0, 1.0}));
  CHECK_FALSE(properlyIntersect({0.0, 0.0}, {2.0, 0.0}, {0.5, 0.0}, {1.5, 0.0}));
}

}  // namespace fulbito
