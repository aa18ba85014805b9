#include "navigation/methods/bspline/spline_cost.hpp"

#include "fulbito/detail/math.hpp"
#include "navigation/methods/bspline/spline_optimiser.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"

namespace fulbito {
namespace {

const FieldGeometry kField;

SplineTask task(double speed) {
  SplineTask t;
  t.limits = speedLimits(test::paperRobot(speed), 1.0, 1.0);
  t.field = &kField;
  return t;
}

CubicSpline straight(Vec2 from, Vec2 to) {
  CubicSpline spline;
  for (int i = 0; i <= 6; ++i) spline.add(from + (to - from) * (i / 6.0));
  return spline;
}

}  // namespace

TEST_CASE("a straight spline takes the ramp-up time of the bound", "[unit]") {
  SplineCost cost(task(1.0));
  const SplineScore score = cost(straight({-0.5, 0.0}, {0.5, 0.0}));
  CHECK(score.time == Approx(1.0 / 1.0 + 1.0 / 10.0).epsilon(0.01));
  CHECK(score.cost == Approx(score.time));
}

TEST_CASE("stopping at the end of a straight spline costs a second ramp", "[unit]") {
  SplineTask stop = task(1.0);
  stop.limits.end_speed = 0.0;
  CHECK(SplineCost(stop)(straight({-0.5, 0.0}, {0.5, 0.0})).time == Approx(1.2).epsilon(0.02));
}

TEST_CASE("a bend is driven as fast as lateral grip allows", "[unit]") {
  CubicSpline circle;  // radius 0.2: v <= sqrt(6 * 0.2)
  for (int i = 0; i < 12; ++i) circle.add(math::unit(0.25 * i) * 0.2);
  SplineTask fast = task(2.6);
  fast.limits.start_speed = 1.0954;
  const double length = 11 * 0.25 * 0.2;
  CHECK(SplineCost(fast)(circle).time == Approx(length / 1.0954).epsilon(0.05));
}

TEST_CASE("a disc on the way makes a spline dear and counts the body's clearance", "[unit]") {
  ForecastDisc disc;
  disc.position = {0.0, 0.06};
  disc.radius = 0.03;
  SplineTask blocked = task(1.0);
  const SplineScore open = SplineCost(blocked)(straight({-0.5, 0.0}, {0.5, 0.0}));
  blocked.discs = std::span<const ForecastDisc>(&disc, 1);
  const SplineScore shut = SplineCost(blocked)(straight({-0.5, 0.0}, {0.5, 0.0}));
  CHECK(shut.time == open.time);
  CHECK(shut.cost > open.cost + 0.5);
  CHECK(shut.clearance == Approx(0.06 - 0.03 - 0.0375).margin(1e-3));
}

TEST_CASE("a moving disc counts where it will be when the robot comes by", "[unit]") {
  ForecastDisc disc;
  disc.position = {0.0, 0.6};
  disc.velocity = {0.0, -1.0};
  disc.radius = 0.05;
  disc.room = {0.7, 0.6};
  disc.moves = true;
  SplineTask crossing = task(1.0);
  crossing.discs = std::span<const ForecastDisc>(&disc, 1);
  // The robot and the disc are in the middle after 0.6 s. A disc that crosses at x = -0.4 does not meet the
  // robot.
  CHECK(SplineCost(crossing)(straight({-0.5, 0.0}, {0.5, 0.0})).clearance < 0.0);
  disc.position.x = -0.4;
  CHECK(SplineCost(crossing)(straight({-0.5, 0.0}, {0.5, 0.0})).clearance == crossing.clearance_wish);
}

TEST_CASE("a spline that folds back on itself is dearer than its time", "[unit]") {
  CubicSpline fold;
  for (double x : {0.0, 0.2, 0.4, 0.6, 0.3, 0.1}) fold.add({x, 0.0});
  const SplineScore score = SplineCost(task(1.0))(fold);
  CHECK(score.cost > score.time + 1.0);
}

TEST_CASE("an unfinished verdict is still no better than what was enough", "[unit]") {
  SplineCost cost(task(1.0));
  CHECK(cost(straight({-0.5, 0.0}, {0.5, 0.0}), 0.3).cost >= 0.3);
}

TEST_CASE("the optimiser never makes a spline worse and gets a crooked one nearly straight", "[unit]") {
  CubicSpline crooked = straight({-0.5, 0.0}, {0.5, 0.0});
  for (std::size_t i = 1; i < 6; ++i)
    crooked.set(i, crooked.control(i) + Vec2{0.0, i % 2 == 0 ? 0.04 : -0.03});
  SplineCost cost(task(2.6));
  SplineOptimiser optimiser;
  optimiser.start(crooked, 1, 1, 0.02);
  double last = cost(crooked).cost;
  for (int round = 0; round < 60; ++round) {
    optimiser.improve(cost, 10);
    CHECK(optimiser.score().cost <= last);
    last = optimiser.score().cost;
  }
  CHECK(last < 1.02 * cost(straight({-0.5, 0.0}, {0.5, 0.0})).cost);
}

TEST_CASE("the optimiser leaves fixed and frozen control points where they are", "[unit]") {
  CubicSpline crooked = straight({-0.5, 0.0}, {0.5, 0.0});
  for (std::size_t i = 1; i < 6; ++i) crooked.set(i, crooked.control(i) + Vec2{0.0, 0.05});
  SplineCost cost(task(2.6));
  SplineOptimiser optimiser;
  optimiser.start(crooked, 2, 2, 0.02);
  optimiser.freezeBefore(3);
  while (!optimiser.converged() && optimiser.improve(cost, 50) > 0) {
  }
  for (std::size_t i : {0, 1, 2, 5, 6}) CHECK(optimiser.best().control(i) == crooked.control(i));
  CHECK(distance(optimiser.best().control(4), crooked.control(4)) > 0.001);
  CHECK(optimiser.converged());
}

}  // namespace fulbito
