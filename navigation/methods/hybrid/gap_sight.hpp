#pragma once

#include <span>
#include <vector>

#include "navigation/methods/hybrid/crowding.hpp"
#include "navigation/obstacles/echo_circles.hpp"
#include "navigation/obstacles/echo_map.hpp"

namespace fulbito {

/// What a robot with sonars sees about it: a coarse map of echoes, and at the edges of narrow gaps circles
/// that are fitted to them. A cell of the map and the width of a cone are as large as the room beside a robot
/// in a narrow gap. Fitted edges are some millimetres better.
class GapSight {
 public:
  explicit GapSight(double memory);
  /// Forgets everything.
  void reset();
  /// Takes in the scene's readings and fills `hits`: the nearest thing in every sector.
  /// @param widest  [m] gaps below it are narrow
  void look(const NavigationScene& scene, double widest, const SectorCircle& sectors,
            std::span<SectorHit> hits);

  /// Narrow gaps that the last look showed.
  std::span<const NarrowGap> gaps() const { return gaps_; }
  const EchoCircles& circles() const { return circles_; }

 private:
  void startEdges(const NavigationScene& scene);

  EchoMap map_;
  EchoCircles circles_;
  std::vector<NarrowGap> gaps_;
};

}  // namespace fulbito
