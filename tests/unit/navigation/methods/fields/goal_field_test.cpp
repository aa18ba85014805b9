#include "navigation/methods/fields/goal_field.hpp"

#include "fulbito/detail/math.hpp"
#include "navigation/geometry/angles.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr double kRadius = 0.0537, kSmoothness = 0.0415;

double spiral(Vec2 p) { return spiralHeading(p, {}, 0.0, kRadius, kSmoothness); }
double gap(double a, double b) { return std::abs(math::wrapAngle(a - b)); }

}  // namespace

TEST_CASE("angles blend along the shorter arc", "[unit]") {
  CHECK(blendAngle(3.0, -3.0, 0.5) == Approx(-math::kPi));
  CHECK(blendAngle(0.2, 0.6, 0.25) == Approx(0.3));
  CHECK(blendAngle(-3.0, 3.0, 1.0) == Approx(3.0));
}

TEST_CASE("the spiral field has the arrival heading at the goal", "[unit]") {
  CHECK(spiral({}) == Approx(0.0).margin(1e-12));
  const Vec2 goal{0.3, -0.2};
  for (double arrival : {-3.0, -1.0, 0.4, 2.5}) {
    CHECK(gap(spiralHeading(goal, goal, arrival, kRadius, kSmoothness), arrival) < 1e-9);
  }
}

TEST_CASE("the spiral field is the arrival heading all along the line of arrival", "[unit]") {
  for (double x : {-0.01, -0.05, -0.2, -1.0, -5.0}) CHECK(gap(spiral({x, 0.0}), 0.0) < 1e-9);
}

TEST_CASE("the spiral field is mirrored about the line of arrival", "[unit]") {
  for (double x : {-0.3, -0.02, 0.1, 0.4}) {
    for (double y : {0.01, 0.06, 0.3}) CHECK(gap(spiral({x, y}), -spiral({x, -y})) < 1e-9);
  }
}

TEST_CASE("the spiral field is continuous on the circle and at the edges of the strip", "[unit]") {
  const double h = 1e-7;
  for (double angle : {0.3, 1.0, 2.0, 3.0}) {  // upper half circle about (0, d_e)
    const Vec2 out = math::unit(angle), centre{0.0, kRadius};
    CHECK(gap(spiral(centre + out * (kRadius - h)), spiral(centre + out * (kRadius + h))) < 1e-4);
  }
  for (double x : {-0.4, -0.05, 0.07, 0.5}) {
    CHECK(gap(spiral({x, kRadius - h}), spiral({x, kRadius + h})) < 1e-4);
    CHECK(gap(spiral({x, -kRadius - h}), spiral({x, -kRadius + h})) < 1e-4);
  }
}

TEST_CASE("the spiral runs along the circle on it and at the centre from far away", "[unit]") {
  const Vec2 centre{0.0, kRadius};
  CHECK(gap(spiral(centre + Vec2{0.0, kRadius}), math::kPi) < 1e-9);  // top, counter-clockwise
  // d_e + K_r over rho + K_r of 1/2 turns by 3/4 of half a circle.
  const double rho = 2.0 * (kRadius + kSmoothness) - kSmoothness;
  CHECK(gap(spiral(centre + Vec2{0.0, rho}), math::kPi / 2 + 0.75 * math::kPi) < 1e-9);
  CHECK(gap(spiral({0.0, 1e6}), -math::kPi / 2) < 1e-5);
}

TEST_CASE("curves of the spiral field end in the goal with the arrival heading", "[unit]") {
  for (Vec2 start : {Vec2{0.5, 0.3}, Vec2{0.4, -0.1}, Vec2{-0.5, 0.4}, Vec2{0.05, 0.2}}) {
    Vec2 p = start;
    double least = 1e9, heading_there = 0.0;
    for (int i = 0; i < 3000; ++i) {
      p += math::unit(spiral(p)) * 0.001;
      if (norm(p) < least) least = norm(p), heading_there = spiral(p);
    }
    INFO(start.x << ", " << start.y);
    CHECK(least < 0.01);
    CHECK(gap(heading_there, 0.0) < 0.2);
  }
}

TEST_CASE("the posture field turns away n times the angle to the guide point, at most by pi", "[unit]") {
  // From (0, 0) to (1, 0) with the guide point at (1, 0.1): alpha = atan(0.1).
  CHECK(postureHeading({}, {1.0, 0.0}, math::kPi / 2, 4.0, 0.1) == Approx(-4.0 * 0.0996686525));
  CHECK(gap(postureHeading({}, {0.1, 0.0}, math::kPi / 2, 8.0, 0.1), math::kPi) < 1e-9);
  CHECK(postureHeading({-0.3, 0.0}, {}, 0.0, 8.0, 0.02) == Approx(0.0).margin(1e-12));
  CHECK(postureHeading({}, {}, 1.2, 8.0, 0.02) == 1.2);
}

TEST_CASE("every goal field is the bearing where no arrival heading is wanted", "[unit]") {
  NavigationGoal goal;
  goal.position = {0.3, 0.4};
  for (GoalFieldKind kind : {GoalFieldKind::kSpiral, GoalFieldKind::kPosture, GoalFieldKind::kBearing}) {
    GoalField field({.kind = kind});
    field.aim(goal);
    CHECK(field.heading({}) == Approx(0.9272952180));
  }
}

}  // namespace fulbito
