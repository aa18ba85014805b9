#include "navigation/geometry/cubic_spline.hpp"

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

double sum(const std::array<double, 4>& w) { return w[0] + w[1] + w[2] + w[3]; }

}  // namespace

TEST_CASE("spline weights are a partition of unity whose derivatives cancel", "[unit]") {
  for (int i = 0; i <= 20; ++i) {
    const SplineWeights w = splineWeights(i / 20.0);
    CHECK(sum(w.position) == Approx(1.0));
    CHECK(sum(w.first) == Approx(0.0).margin(1e-15));
    CHECK(sum(w.second) == Approx(0.0).margin(1e-15));
  }
}

TEST_CASE("spline weights at the knots and the middle are those of the uniform cubic basis", "[unit]") {
  const SplineWeights knot = splineWeights(0.0), middle = splineWeights(0.5);
  CHECK(knot.position[0] == Approx(1.0 / 6));
  CHECK(knot.position[1] == Approx(4.0 / 6));
  CHECK(knot.position[2] == Approx(1.0 / 6));
  CHECK(knot.position[3] == 0.0);
  CHECK(middle.position[0] == Approx(1.0 / 48));
  CHECK(middle.position[1] == Approx(23.0 / 48));
  CHECK(middle.first[0] == Approx(-1.0 / 8));
  CHECK(middle.first[2] == Approx(5.0 / 8));
  CHECK(middle.second[1] == Approx(-0.5));
}

TEST_CASE("the derivatives of the weights agree with finite differences", "[unit]") {
  const double h = 1e-5;
  for (double u : {0.1, 0.45, 0.8}) {
    const SplineWeights low = splineWeights(u - h), here = splineWeights(u), high = splineWeights(u + h);
    for (std::size_t k = 0; k < 4; ++k) {
      CHECK(here.first[k] == Approx((high.position[k] - low.position[k]) / (2 * h)).margin(1e-8));
      CHECK(here.second[k] == Approx((high.first[k] - low.first[k]) / (2 * h)).margin(1e-8));
    }
  }
}

TEST_CASE("a spline begins and ends in its outer control points without curvature", "[unit]") {
  CubicSpline spline;
  for (Vec2 c : {Vec2{0, 0}, Vec2{0.1, 0.2}, Vec2{0.4, 0.1}, Vec2{0.5, -0.2}}) spline.add(c);
  const SplinePoint first = spline.at(0, splineWeights(0.0));
  const SplinePoint last = spline.at(spline.spans() - 1, splineWeights(1.0));
  CHECK(distance(first.position, {0, 0}) < 1e-15);
  CHECK(distance(last.position, {0.5, -0.2}) < 1e-15);
  CHECK(norm(first.second) < 1e-15);
  CHECK(norm(last.second) < 1e-15);
  CHECK(cross(first.first, Vec2{0.1, 0.2}) == Approx(0.0).margin(1e-15));
}

TEST_CASE("place, slope and bend are continuous where spans meet", "[unit]") {
  CubicSpline spline;
  for (int i = 0; i < 7; ++i) spline.add({0.2 * i, i % 3 == 0 ? 0.1 : -0.05 * i});
  for (std::size_t s = 0; s + 1 < spline.spans(); ++s) {
    const SplinePoint before = spline.at(s, splineWeights(1.0)), after = spline.at(s + 1, splineWeights(0.0));
    CHECK(distance(before.position, after.position) < 1e-14);
    CHECK(distance(before.first, after.first) < 1e-14);
    CHECK(distance(before.second, after.second) < 1e-14);
  }
}

TEST_CASE("control points on a circle give about its curvature with the turn's sign", "[unit]") {
  for (double turn : {1.0, -1.0}) {
    CubicSpline spline;
    for (int i = 0; i < 9; ++i) spline.add(math::unit(turn * 0.1 * i) * 0.5);
    const SplinePoint middle = spline.at(4, splineWeights(0.3));
    CHECK(curvature(middle) == Approx(turn / 0.5).epsilon(0.01));
  }
}

TEST_CASE("moving one control point leaves spans alone that are further than two away", "[unit]") {
  CubicSpline spline;
  for (int i = 0; i < 9; ++i) spline.add({0.2 * i, 0.0});
  CubicSpline moved = spline;
  moved.set(5, {1.0, 0.3});
  for (std::size_t s = 0; s < spline.spans(); ++s) {
    const double gap =
        distance(spline.at(s, splineWeights(0.5)).position, moved.at(s, splineWeights(0.5)).position);
    CHECK((gap > 0.0) == (s >= 3 && s <= 6));
  }
}

TEST_CASE("control points beyond the limit are ignored", "[unit]") {
  CubicSpline spline;
  for (std::size_t i = 0; i < CubicSpline::kMaxControls + 3; ++i) spline.add({static_cast<double>(i), 0.0});
  CHECK(spline.controls() == CubicSpline::kMaxControls);
}

}  // namespace fulbito
