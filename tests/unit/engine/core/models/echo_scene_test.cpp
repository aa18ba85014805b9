#include "fulbito/detail/echo_scene.hpp"

#include <array>
#include <cmath>

#include "engine/core/math/random.hpp"
#include "engine/core/models/shapes.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;

namespace {

constexpr double kDegree = math::kPi / 180.0;
constexpr double kHalfCone = 12.5 * kDegree;
constexpr double kLimit = 30.0 * kDegree;

EchoScene room(double length, double width) {
  const double x = length / 2, y = width / 2;
  const std::array<Vec2, 4> contour{{{-x, -y}, {x, -y}, {x, y}, {-x, y}}};
  EchoScene scene;
  scene.addRoom(contour);
  return scene;
}

EchoScene boxAt(Vec2 position, double heading, double size) {
  EchoScene scene;
  scene.addBody(cornersOf({{position, heading}, size, size}));
  return scene;
}

EchoScene discOf(Vec2 centre, double radius) {
  EchoScene scene;
  scene.addDisc(centre, radius);
  return scene;
}

Cone cone(double bearing, double half_angle = kHalfCone, Vec2 apex = {}) {
  return {apex, math::unit(bearing), half_angle, 5.0};
}

/// A second implementation: the nearest hit of many rays.
double nearestOfRays(const EchoScene& scene, const Cone& cone, double limit, int rays) {
  double nearest = 1e9;
  const double axis = math::angleOf(cone.axis);
  for (int i = -rays; i <= rays; ++i) {
    const Vec2 way = math::unit(axis + cone.half_angle * i / rays);
    const RayHit hit = scene.castRay(cone.apex, way, cone.reach);
    if (hit.isHit() && -dot(hit.normal, way) >= std::cos(limit)) nearest = std::min(nearest, hit.distance);
  }
  return nearest;
}

}  // namespace

TEST_CASE("a ray ends at the first wall, disc or box, with its normal", "[unit]") {
  EchoScene scene = room(4.0, 3.0);
  const RayHit wall = scene.castRay({0.5, 0.0}, {1.0, 0.0}, 10.0);
  CHECK(wall.distance == Approx(1.5));
  CHECK(wall.normal.x == Approx(-1.0));
  scene.addDisc({1.0, 0.03}, 0.05);
  const RayHit disc = scene.castRay({0.5, 0.0}, {1.0, 0.0}, 10.0);
  CHECK(disc.distance == Approx(0.5 - 0.04));
  CHECK(disc.normal.x == Approx(-0.8));
  CHECK(disc.normal.y == Approx(-0.6));
  scene.addBody(cornersOf({{{0.8, 0.0}, 0.0}, 0.1, 0.2}));
  CHECK(scene.castRay({0.5, 0.0}, {1.0, 0.0}, 10.0).distance == Approx(0.25));
  CHECK(scene.castRay({0.5, 0.0}, {0.0, 1.0}, 10.0).distance == Approx(1.5));
  CHECK_FALSE(scene.castRay({0.5, 0.0}, {1.0, 0.0}, 0.24).isHit());
}

TEST_CASE("a cone hears a wall along its perpendicular while that is inside the cone", "[unit]") {
  const EchoScene scene = room(4.0, 3.0);
  for (double tilt : {0.0, 3.0, -7.0, 12.0}) {
    CAPTURE(tilt);
    const Echo echo = scene.castCone(cone(tilt * kDegree), kLimit);
    CHECK(echo.distance == Approx(2.0));
    CHECK(echo.point.y == Approx(0.0).margin(1e-12));
  }
}

TEST_CASE("beyond the cone the wall's nearest point is on the cone's edge, until the specular limit",
          "[unit]") {
  const EchoScene scene = room(4.0, 30.0);
  for (double tilt : {20.0, -30.0, 42.0}) {
    CAPTURE(tilt);
    const double incidence = std::abs(tilt) - 12.5;
    const Echo echo = scene.castCone(cone(tilt * kDegree), kLimit);
    CHECK(echo.distance == Approx(2.0 / std::cos(incidence * kDegree)));
  }
  CHECK_FALSE(scene.castCone(cone(43.0 * kDegree), kLimit).isHeard());
  CHECK(scene.castCone(cone(43.0 * kDegree), 31.0 * kDegree).isHeard());
  // A rough wall reflects at any incidence.
  CHECK(scene.castCone(cone(60.0 * kDegree), math::kPi / 2).distance ==
        Approx(2.0 / std::cos(47.5 * kDegree)));
}

TEST_CASE("a cone hears a disc along the line to its centre, or where its edge meets the disc", "[unit]") {
  const EchoScene scene = discOf({1.0, 0.0}, 0.1);
  CHECK(scene.castCone(cone(10.0 * kDegree), kLimit).distance == Approx(0.9));
  const double off = 2.0 * kDegree;  // between the cone's edge and the centre
  const double expected = std::cos(off) - std::sqrt(0.01 - std::sin(off) * std::sin(off));
  CHECK(scene.castCone(cone(14.5 * kDegree), kLimit).distance == Approx(expected));
  CHECK(scene.castCone(cone(-14.5 * kDegree), kLimit).distance == Approx(expected));
  CHECK(scene.castCone(cone(14.5 * kDegree), kLimit).point.y > 0.0);
  CHECK(scene.castCone(cone(-14.5 * kDegree), kLimit).point.y < 0.0);
  // The cone's edge meets the disc at asin(sin(off) / 0.1): 30 degrees are passed at off = 2.866 degrees.
  CHECK(scene.castCone(cone((12.5 + 2.86) * kDegree), kLimit).isHeard());
  CHECK_FALSE(scene.castCone(cone((12.5 + 2.87) * kDegree), kLimit).isHeard());
  CHECK_FALSE(scene.castCone(cone(math::kPi), kLimit).isHeard());
}

TEST_CASE("a box's corner answers between the normals of its faces", "[unit]") {
  const EchoScene diamond = boxAt({1.0, 0.0}, math::kPi / 4, 0.1);
  const double to_corner = 1.0 - 0.05 * std::sqrt(2.0);
  // The faces are inclined by 45 degrees: smooth ones reflect the sound sideways, but the corner reflects it
  // back.
  CHECK(diamond.castCone(cone(0.0), kLimit).distance == Approx(to_corner));
  CHECK(diamond.castCone(cone(12.4 * kDegree), kLimit).distance == Approx(to_corner));
  CHECK_FALSE(diamond.castCone(cone(18.0 * kDegree), kLimit).isHeard());
  const EchoScene square = boxAt({1.0, 0.0}, 0.0, 0.1);
  CHECK(square.castCone(cone(0.0), kLimit).distance == Approx(0.95));
  // The cone's edge passes the near face and hears its corner at 3.01 degrees.
  CHECK(square.castCone(cone(15.0 * kDegree), kLimit).distance == Approx(0.95 / std::cos(2.5 * kDegree)));
}

TEST_CASE("a room's right corner throws sound back, an obtuse one does not", "[unit]") {
  const EchoScene square = room(4.0, 4.0);
  CHECK(square.castCone(cone(45.0 * kDegree, 5.0 * kDegree), kLimit).distance ==
        Approx(2.0 * std::sqrt(2.0)));
  const std::array<Vec2, 5> contour{{{-2, -2}, {2, -2}, {2, 1}, {1, 2}, {-2, 2}}};
  EchoScene cut;
  cut.addRoom(contour);
  CHECK_FALSE(cut.castCone(cone(math::atan2(1.0, 2.0), 5.0 * kDegree), 10.0 * kDegree).isHeard());
}

TEST_CASE("what smooth faces hide is not heard", "[unit]") {
  EchoScene scene = discOf({2.0, 0.0}, 0.1);
  CHECK(scene.castCone(cone(0.0, 2.0 * kDegree), kLimit).distance == Approx(1.9));
  // A plate in front of it, inclined by 60 degrees.
  scene.addBody(cornersOf({{{1.0, 0.0}, 30.0 * kDegree}, 0.6, 0.01}));
  CHECK_FALSE(scene.castCone(cone(0.0, 2.0 * kDegree), kLimit).isHeard());
}

TEST_CASE("a surface whose nearest point is hidden answers with a part that is not", "[unit]") {
  EchoScene scene = room(4.0, 30.0);
  // A plate inclined by 45 degrees hides the wall's nearest point, and all up to 2.7 degrees to the left.
  scene.addBody(cornersOf({{{0.775, -0.225}, 45.0 * kDegree}, 0.778, 0.001}));
  const Echo echo = scene.castCone(cone(0.0, 20.0 * kDegree), 15.0 * kDegree);
  const double angle = math::angleOf(echo.point) / kDegree;
  CHECK(angle > 2.7);
  CHECK(angle < 3.8);
  CHECK(echo.distance == Approx(2.0 / std::cos(angle * kDegree)));
}

TEST_CASE("cones agree with many rays over random scenes", "[unit]") {
  Rng rng(31, test::kTestStream);
  int heard = 0;
  for (int i = 0; i < 300; ++i) {
    CAPTURE(i);
    EchoScene scene = room(2.0, 1.6);
    for (int k = 0; k < 5; ++k) {
      const Vec2 at = math::unit(rng.uniform(-3.1, 3.1)) * rng.uniform(0.2, 0.6);
      if (k % 2 == 0) {
        scene.addDisc(at, rng.uniform(0.03, 0.1));
      } else {
        scene.addBody(cornersOf({{at, rng.uniform(-3.1, 3.1)}, 0.1, 0.08}));
      }
    }
    const Cone listening = cone(rng.uniform(-3.1, 3.1));
    const double exact = scene.castCone(listening, math::kPi / 2).distance;
    const double rays = nearestOfRays(scene, listening, math::kPi / 2, 3000);
    REQUIRE(exact <= rays + 1e-9);
    // Where the nearest point is partly hidden, one ray per degree samples the visible rest.
    CHECK(exact == Approx(rays).margin(0.004));
    heard += rays < 1e8 ? 1 : 0;
  }
  CHECK(heard == 300);
}
