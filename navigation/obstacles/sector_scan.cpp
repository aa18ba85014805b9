#include "navigation/obstacles/sector_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "navigation/geometry/wall_lines.hpp"

namespace fulbito {
namespace {

constexpr double kTouching = 1e-4;  // [m] stands for "inside", since distance 0 has no direction
constexpr double kFar = 1e3;        // [m] obstacles farther away do not matter, and squares stay finite

void keepNearest(SectorHit& hit, double distance, Vec2 direction) {
  if (distance < hit.distance) hit = {distance, direction * distance};
}

/// A hit on an edge belongs to the sectors on both sides.
void keepOnEdge(const SectorCircle& circle, int edge, double distance, std::span<SectorHit> hits) {
  keepNearest(hits[static_cast<std::size_t>(edge)], distance, circle.edge(edge));
  keepNearest(hits[static_cast<std::size_t>(circle.wrap(edge - 1))], distance, circle.edge(edge));
}

void addWalls(const SectorCircle& circle, std::span<const WallLine> walls, std::span<SectorHit> hits) {
  for (int i = 0; i < circle.count(); ++i) {
    double nearness = 1.0 / kFar;  // reciprocal of the distance, which saves a division per wall
    for (const WallLine& wall : walls)
      nearness = std::max(nearness, dot(wall.outward, circle.edge(i)) / wall.clearance);
    if (nearness > 1.0 / kFar) keepOnEdge(circle, i, 1.0 / nearness, hits);
  }
  for (const WallLine& wall : walls) {
    const int facing = circle.sectorOf(math::angleOf(wall.outward));
    keepNearest(hits[static_cast<std::size_t>(facing)], wall.clearance, wall.outward);
  }
}

}  // namespace

SectorCircle::SectorCircle(int count) : count_(count), step_(2.0 * math::kPi / count) {
  for (int i = 0; i < count; ++i) {
    directions_.push_back(math::unit(math::kPi - step_ * i));
    edges_.push_back(math::unit(math::kPi - step_ * (i - 0.5)));
  }
}

double SectorCircle::bearing(int sector) const { return math::wrapAngle(math::kPi - step_ * sector); }

int SectorCircle::sectorOf(double bearing) const {
  return wrap(static_cast<int>(std::floor((math::kPi - math::wrapAngle(bearing)) / step_ + 0.5)));
}

void scanDisc(const SectorCircle& circle, Vec2 centre, double radius, std::span<SectorHit> hits) {
  const double range = norm(centre);
  if (!(range - radius < kFar)) return;
  for (int i = 0; i < circle.count(); ++i) {
    const double along = dot(centre, circle.edge(i)), across = cross(centre, circle.edge(i));
    const double chord = radius * radius - across * across;
    if (along <= 0.0 || chord < 0.0) continue;
    keepOnEdge(circle, i, std::max(along - std::sqrt(chord), kTouching), hits);
  }
  const int facing = circle.sectorOf(math::angleOf(centre));
  keepNearest(hits[static_cast<std::size_t>(facing)], std::max(range - radius, kTouching),
              unitOr(centre, {1.0, 0.0}));
}

void scanScene(const SectorCircle& circle, const NavigationScene& scene, std::span<SectorHit> hits) {
  for (SectorHit& hit : hits) hit = {std::numeric_limits<double>::infinity(), {}};
  const Pose2& pose = scene.self.pose;
  const Vec2 ux = math::unit(pose.heading);
  for (const DiscObstacle& obstacle : scene.obstacles) {
    scanDisc(circle, intoFrame(ux, obstacle.position - pose.position), obstacle.radius, hits);
  }
  auto walls = wallLines(*scene.field, pose);
  for (WallLine& wall : walls) wall.clearance = std::max(wall.clearance, kTouching);
  addWalls(circle, walls, hits);
}

}  // namespace fulbito
