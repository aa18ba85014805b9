#include "navigation/methods/curvature/double_arc.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

constexpr double kDegree = math::kPi / 180;
const Pose2 kStart{{0.0, 0.0}, 90 * kDegree};  // start of all trajectories in Choi & Lee (2005)

}  // namespace

// Table 1 contradicts itself: it gives R = 3.75 m, a turn of 109.65 degrees and the end (5, 4, 109.6
// degrees).
TEST_CASE("the single arc of Table 1 ends 0.47 m below the printed place, and heads elsewhere", "[unit]") {
  const Arc printed{kStart, -1 / 3.75, 3.75 * 109.65 * kDegree};
  CHECK(printed.length == Approx(7.18).epsilon(0.001));
  const Pose2 end = endOf(printed);
  CHECK(end.position.x == Approx(5.011).epsilon(1e-3));
  CHECK(end.position.y == Approx(3.532).epsilon(1e-3));
  CHECK(end.heading == Approx(-19.65 * kDegree));
  const Arc through = arcThrough(kStart, {5.0, 4.0});
  CHECK(through.curvature == Approx(-1 / 4.1));
  CHECK(through.turn() == Approx(-102.68 * kDegree).epsilon(1e-4));
  CHECK(through.length == Approx(7.348).epsilon(1e-4));
  CHECK(endOf(through).heading == Approx(-12.68 * kDegree).epsilon(1e-3));
}

// Table 1 contradicts itself: it gives R = 1.875 m and the centres (1.87, 0) and (3.13, 4).
TEST_CASE("the double arcs of Table 1 do not touch; those to its end have a radius of 2.05 m", "[unit]") {
  CHECK(distance(Vec2{1.87, 0.0}, Vec2{3.13, 4.0}) == Approx(4.19).epsilon(1e-3));  // more than 2 * 1.875
  const DoubleArc arcs = doubleArc(kStart, {{5.0, 4.0}, 90 * kDegree});
  CHECK(arcs.first.curvature == Approx(-1 / 2.05));
  CHECK(arcs.second.curvature == Approx(1 / 2.05));
  CHECK(endOf(arcs.first).position.x == Approx(2.5));
  CHECK(endOf(arcs.first).position.y == Approx(2.0));
  const Pose2 end = endOf(arcs.second);
  CHECK(end.position.x == Approx(5.0));
  CHECK(end.position.y == Approx(4.0));
  CHECK(end.heading == Approx(90 * kDegree));
  const double turn = 109.65 * kDegree;
  const Arc first{kStart, -1 / 1.875, 1.875 * turn};
  const Pose2 printed = endOf(Arc{endOf(first), 1 / 1.875, 1.875 * turn});
  CHECK(printed.position.x == Approx(5.01).epsilon(1e-3));
  CHECK(printed.position.y == Approx(3.53).epsilon(1e-3));
}

TEST_CASE("single and double arcs to one place are equally long, with radii of two to one", "[unit]") {
  for (const Vec2 goal : {Vec2{5.0, 4.0}, Vec2{1.0, 3.0}, Vec2{4.0, 0.5}}) {
    const Arc single = arcThrough(kStart, goal);
    const DoubleArc both = doubleArc(kStart, {goal, 90 * kDegree});
    CHECK(both.length() == Approx(single.length));
    CHECK(both.first.curvature == Approx(2 * single.curvature));
    CHECK(both.second.turn() == Approx(-both.first.turn()));
  }
}

TEST_CASE("two arcs join any two poses with one tangent", "[unit]") {
  for (int i = 0; i < 400; ++i) {
    const double a = 0.1 * i;
    const Pose2 start{{0.3, -0.2}, 1.3 * a}, goal{{0.3 + math::cos(a), -0.2 + math::sin(a)}, 0.7 * a};
    const DoubleArc arcs = doubleArc(start, goal);
    if (!std::isfinite(arcs.length())) continue;
    const Pose2 joint = endOf(arcs.first), end = endOf(arcs.second);
    CHECK(distance(joint.position, arcs.second.start.position) < 1e-9);
    CHECK(std::abs(math::wrapAngle(joint.heading - arcs.second.start.heading)) < 1e-9);
    CHECK(distance(end.position, goal.position) < 1e-9);
    CHECK(std::abs(math::wrapAngle(end.heading - goal.heading)) < 1e-6);
  }
}

TEST_CASE("a goal straight behind with the same heading has no two finite arcs, a goal here no length",
          "[unit]") {
  CHECK(std::isinf(doubleArc({}, {{-1.0, 0.0}, 0.0}).length()));
  CHECK(doubleArc(kStart, {{1.0, 0.0}, 90 * kDegree}).length() == Approx(math::kPi / 2));  // two half circles
  CHECK(doubleArc(kStart, kStart).length() == 0.0);
  const DoubleArc line = doubleArc(kStart, {{0.0, 2.0}, 90 * kDegree});
  CHECK(line.length() == Approx(2.0));
}

}  // namespace fulbito
