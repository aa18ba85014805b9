#include "experiments/papers/capture/sightings.hpp"

#include <cmath>
#include <vector>

#include "engine/core/math/random.hpp"
#include "experiments/papers/capture/fig18.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;

Sighting sightingOf(const ObjectMotion& object, Vec2 from, double time) {
  const Vec2 to = object.at(time) - from;
  return {time, from, math::angleOf(to), norm(to)};
}

}  // namespace

TEST_CASE("two exact sightings give place, speed and heading", "[unit]") {
  const ObjectMotion object{{2.0, 0.0}, {0.2, -0.1}, 0.0};
  const ObjectMotion found =
      fromTwo(sightingOf(object, {1.0, 2.0}, 0.5), sightingOf(object, {1.5, 2.5}, 1.5));  // from two places
  CHECK(found.time == 1.5);
  CHECK(distance(found.position, object.at(1.5)) < 1e-12);
  CHECK(distance(found.velocity, object.velocity) < 1e-12);
}

// Misprint: the left side of (17) lacks the square.
TEST_CASE("the law of cosines gives the way of the object, not its square", "[unit]") {
  const Sighting first{0.0, {}, 90 * kDegree, 3.0}, second{1.0, {}, 0.0, 4.0};
  const SightingTriangle triangle = triangleOf(first, second);
  CHECK(triangle.l3 == Approx(5.0));  // as printed: 25
  CHECK(triangle.theta3 == Approx(90 * kDegree));
  CHECK(triangle.theta2 == Approx(math::atan2(4.0, 3.0)));
  CHECK(triangle.l3 == Approx(distance(placeOf(first), placeOf(second))));
}

// Misprint: (21) holds only for a robot's heading of 90 degrees and a decreasing bearing.
TEST_CASE("the triangle gives the heading on both sides of the robot", "[unit]") {
  for (int i = 0; i < 60; ++i) {
    const ObjectMotion object{{2.0, 0.3}, math::unit(0.1 * i) * 0.3, 0.0};
    const Sighting first = sightingOf(object, {0.5, -1.0}, 0.0),
                   second = sightingOf(object, {0.5, -1.0}, 1.0);
    const double off = math::wrapAngle(headingByTriangle(first, second) - math::angleOf(object.velocity));
    CHECK(std::abs(off) < 1e-6);
  }
}

TEST_CASE("the printed heading of the paper's own object is -135.8 degrees instead of 40", "[unit]") {
  const ObjectMotion object = fig18Object();
  const Vec2 robot = fig18Robot().position;
  const Sighting first = sightingOf(object, robot, 0.0), second = sightingOf(object, robot, 2.0);
  const SightingTriangle triangle = triangleOf(first, second);
  const double theta0 = second.bearing - fig18Robot().heading;  // pan of the camera
  const double printed = triangle.theta2 + triangle.theta3 + theta0 - math::kPi / 2;
  CHECK(math::wrapAngle(printed) / kDegree == Approx(-135.8).margin(0.1));
  CHECK(headingByTriangle(first, second) / kDegree == Approx(40.0));
}

TEST_CASE("the printed heading is right where the bearing decreases and the robot looks along y", "[unit]") {
  const ObjectMotion object{{-1.0, 2.0}, math::unit(10 * kDegree) * 0.3, 0.0};  // it crosses to the right
  const Sighting first = sightingOf(object, {}, 0.0), second = sightingOf(object, {}, 1.0);
  const SightingTriangle triangle = triangleOf(first, second);
  const double pan = second.bearing - 90 * kDegree;
  const double printed = triangle.theta2 + triangle.theta3 + pan - math::kPi / 2;
  CHECK(math::wrapAngle(printed) / kDegree == Approx(10.0));
  CHECK(headingByTriangle(first, second) / kDegree == Approx(10.0));
}

TEST_CASE("least squares are exact without noise, from a moving robot too", "[unit]") {
  const ObjectMotion object{{2.0, 0.0}, {0.2, 0.25}, 0.0};
  std::vector<Sighting> sightings;
  for (int i = 0; i < 7; ++i) sightings.push_back(sightingOf(object, {1.0 + 0.2 * i, 2.0}, 0.3 * i));
  const ObjectMotion found = fitMotion(sightings, {0.02, 0.01});
  CHECK(found.time == Approx(1.8));
  CHECK(distance(found.position, object.at(1.8)) < 1e-9);
  CHECK(distance(found.velocity, object.velocity) < 1e-9);
}

TEST_CASE("least squares of five sightings beat two, and weights beat none", "[unit]") {
  const ObjectMotion object{{4.0, 1.0}, {-0.1, 0.3}, 0.0};
  const SightingNoise noise{0.01, 3 * kDegree};  // much worse across the line of sight than along it
  Rng rng(1, test::kTestStream, 4);
  double two = 0.0, five = 0.0, unweighted = 0.0;
  for (int n = 0; n < 300; ++n) {
    std::vector<Sighting> sightings;
    for (int i = 0; i < 5; ++i) {
      const Vec2 from{0.5 * i, 0.0};
      sightings.push_back(sightingOf(object, from, 0.25 * i));
      sightings.back().range += rng.normal(0.0, noise.range);
      sightings.back().bearing += rng.normal(0.0, noise.bearing);
    }
    two += squaredNorm(fromTwo(sightings.front(), sightings.back()).velocity - object.velocity);
    five += squaredNorm(fitMotion(sightings, noise).velocity - object.velocity);
    unweighted += squaredNorm(fitMotion(sightings, {}).velocity - object.velocity);
  }
  CHECK(five < 0.9 * two);
  CHECK(five < unweighted);
}

}  // namespace fulbito::capture
