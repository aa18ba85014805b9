#pragma once

#include <span>
#include <vector>

#include "fulbito/navigation.hpp"

namespace fulbito {

/// Greatest number of sectors of a circle.
inline constexpr int kMaxSectors = 360;

/// The full circle around a robot cut into `count` equal sectors, robot frame. Sector i has its bisector at
/// pi - (2 pi / count) i: numbers grow clockwise and start straight behind the robot.
class SectorCircle {
 public:
  /// @param count  4 ... kMaxSectors
  explicit SectorCircle(int count);
  int count() const { return count_; }
  /// Angle [rad] of one sector.
  double step() const { return step_; }
  /// `sector` modulo the number of sectors, in 0 ... count - 1.
  int wrap(int sector) const { return ((sector % count_) + count_) % count_; }
  /// Bisector [rad] in [-pi, pi).
  double bearing(int sector) const;
  /// The sector that holds a finite bearing [rad].
  int sectorOf(double bearing) const;
  /// Unit vector along the bisector.
  Vec2 direction(int sector) const { return directions_[static_cast<std::size_t>(sector)]; }
  /// Unit vector along the edge between `sector` - 1 and `sector`.
  Vec2 edge(int sector) const { return edges_[static_cast<std::size_t>(sector)]; }

 private:
  int count_;
  double step_;
  std::vector<Vec2> directions_;
  std::vector<Vec2> edges_;
};

/// The obstacle point in a sector that is nearest to the robot's centre.
struct SectorHit {
  double distance = 0.0;  ///< [m] > 0; infinite if the sector is empty
  Vec2 point;             ///< [m] in the robot's frame; valid only if `distance` is finite

  bool isEmpty() const { return !(distance < 1e300); }
};

/// Adds a disc: its nearest point in every sector that it covers.
/// @param centre  [m] in the robot's frame
void scanDisc(const SectorCircle& circle, Vec2 centre, double radius, std::span<SectorHit> hits);

/// Nearest exact point of discs and walls (the playing rectangle with its corner triangles) in every sector.
/// Within a sector the range of a disc or a wall is least on an edge of the sector or at the foot of the
/// perpendicular. If the centre is inside an obstacle, the distance is 0.1 mm.
/// @param hits  one element per sector
void scanScene(const SectorCircle& circle, const NavigationScene& scene, std::span<SectorHit> hits);

}  // namespace fulbito
