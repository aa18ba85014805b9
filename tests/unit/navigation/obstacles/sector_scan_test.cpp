#include "navigation/obstacles/sector_scan.hpp"

#include <algorithm>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

constexpr double kDegree = math::kPi / 180.0;

double room(const NavigationScene& scene, Vec2 p) {
  double least = wallClearance(*scene.field, p);
  for (const DiscObstacle& o : scene.obstacles) least = std::min(least, distance(p, o.position) - o.radius);
  return least;
}

/// Length of a ray by steps of the free distance, which is independent of the ray formulas.
double walkRay(const NavigationScene& scene, double bearing) {
  const Pose2& pose = scene.self.pose;
  const Vec2 way = math::unit(pose.heading + bearing);
  double t = 0.0;
  for (int step = 0; step < 500; ++step) {
    const double free = room(scene, pose.position + way * t);
    if (free < 1e-7) break;
    t += free;
  }
  return t;
}

}  // namespace

TEST_CASE("sectors grow clockwise from straight behind", "[unit]") {
  const SectorCircle circle(180);
  CHECK(circle.bearing(0) == Approx(-math::kPi));
  CHECK(circle.bearing(45) == Approx(math::kPi / 2));
  CHECK(circle.bearing(90) == Approx(0.0).margin(1e-12));
  CHECK(circle.sectorOf(0.9 * kDegree) == 90);
  CHECK(circle.sectorOf(1.1 * kDegree) == 89);
  CHECK(circle.sectorOf(-math::kPi + 0.001) == 0);
  CHECK(circle.sectorOf(math::kPi - 0.001) == 0);
  for (int i = 0; i < circle.count(); ++i) CHECK(circle.sectorOf(circle.bearing(i)) == i);
}

TEST_CASE("a sector's distance is the least over many rays cast in it", "[unit]") {
  const SectorCircle circle(60);
  const FieldGeometry field;
  Rng rng(11, test::kTestStream);
  std::vector<SectorHit> hits(60);
  for (int round = 0; round < 15; ++round) {
    std::vector<DiscObstacle> balls;
    NavigationScene scene;
    scene.field = &field;
    scene.self.pose = {{rng.uniform(-0.65, 0.65), rng.uniform(-0.55, 0.55)}, rng.uniform(-3.0, 3.0)};
    while (balls.size() < 4) {
      const Vec2 p{rng.uniform(-0.7, 0.7), rng.uniform(-0.6, 0.6)};
      if (distance(p, scene.self.pose.position) > 0.05) balls.push_back({p, 0.0335, {}});
    }
    scene.obstacles = balls;
    scanScene(circle, scene, hits);
    for (int i = 0; i < circle.count(); ++i) {
      double least = 1e9;
      for (int ray = 0; ray <= 20; ++ray) {
        least = std::min(least, walkRay(scene, circle.bearing(i) + circle.step() * (ray / 20.0 - 0.5)));
      }
      const SectorHit& hit = hits[static_cast<std::size_t>(i)];
      CHECK(hit.distance == Approx(least).margin(2e-4));
      CHECK(hit.distance == Approx(norm(hit.point)));
    }
  }
}

TEST_CASE("a robot inside an obstacle or beyond a wall still gets positive distances", "[unit]") {
  const SectorCircle circle(36);
  const FieldGeometry field;
  const std::vector<DiscObstacle> balls = {{{0.8, 0.0}, 0.0335, {}}};
  NavigationScene scene;
  scene.field = &field;
  scene.obstacles = balls;
  scene.self.pose = {{0.8, 0.0}, 0.0};
  std::vector<SectorHit> hits(36);
  scanScene(circle, scene, hits);
  for (const SectorHit& hit : hits) {
    CHECK(hit.distance > 0.0);
    CHECK(isFinite(hit.point));
  }
}

}  // namespace fulbito
