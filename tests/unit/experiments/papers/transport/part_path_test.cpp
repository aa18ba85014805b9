#include "experiments/papers/transport/part_path.hpp"

#include <catch2/catch.hpp>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

PartPath hook() {
  const Arc line{{{0.0, 0.0}, 0.0}, 0.0, 1.0};
  const Arc arc{endOf(line), 2.0, math::kPi / 2};  // half a circle of radius 0.5 to the left
  const Arc back{{endOf(arc).position, math::kPi / 2}, 0.0, 1.0};
  return PartPath({line, arc, back});
}

}  // namespace

TEST_CASE("a coordinate counts along all parts", "[unit]") {
  const PartPath path = hook();
  CHECK(path.length() == Approx(2.0 + math::kPi / 2));
  CHECK(path.partAt(-0.1) == 0);
  CHECK(path.partAt(0.5) == 0);
  CHECK(path.partAt(1.0) == 1);
  CHECK(path.partAt(path.length() + 1.0) == 2);
  const Pose2 top = path.pose(1.0 + math::kPi / 4);
  CHECK(top.position.x == Approx(1.5));
  CHECK(top.position.y == Approx(0.5));
}

TEST_CASE("a part's line or circle goes on beyond its ends", "[unit]") {
  const PartPath path = hook();
  CHECK(path.pose(0, 1.2).position.x == Approx(1.2));
  CHECK(path.pose(1, 1.0 - 0.5 * math::kPi / 2).position.x == Approx(0.5));
  CHECK(path.pose(1, 1.0 - 0.5 * math::kPi / 2).position.y == Approx(0.5));
}

TEST_CASE("headings jump at corners only", "[unit]") {
  const PartPath path = hook();
  CHECK(path.jumpAfter(0) == Approx(0.0).margin(1e-12));
  CHECK(path.jumpAfter(1) == Approx(-math::kPi / 2));
}

TEST_CASE("the nearest point is found on lines, arcs and their ends", "[unit]") {
  const PartPath path = hook();
  CHECK(path.nearest({0.3, 0.2}) == Approx(0.3));
  CHECK(path.nearest({2.0, 0.5}) == Approx(1.0 + math::kPi / 4));
  CHECK(path.nearest({-1.0, -1.0}) == 0.0);
  CHECK(path.nearest({1.0, 9.0}) == Approx(path.length()));
  // For a right turn, angles count in the opposite sense.
  const Arc right{{{0.0, 0.0}, math::kPi / 2}, -1.0, math::kPi / 2};
  CHECK(nearestOn(right, Vec2{1.0, 0.0} + math::unit(2.0) * 3.0) == Approx(math::kPi - 2.0));
  CHECK(nearestOn(right, {0.2, -1.0}) == Approx(0.0));
}

}  // namespace fulbito
