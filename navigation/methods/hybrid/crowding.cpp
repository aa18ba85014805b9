#include "navigation/methods/hybrid/crowding.hpp"

#include <cmath>

namespace fulbito {
namespace {

/// Walks from left to right through all but the quarter behind the robot, obstacle by obstacle. A robot is in
/// a gap until its rear corners have left it, so what is beside and half behind counts.
class Surroundings {
 public:
  Surroundings(const SectorCircle& circle, std::span<const SectorHit> hits, double radius)
      : circle_(circle), hits_(hits), jump_(2.0 * radius) {}

  /// Calls `work(hit, number of its obstacle, whether it begins one)` for every point.
  template <typename Work>
  void forPoints(const Work& work) const {
    int obstacle = -1;
    const SectorHit* last = nullptr;
    for (int i = circle_.count() / 8; i <= circle_.count() * 7 / 8; ++i) {
      const SectorHit& hit = hits_[static_cast<std::size_t>(i)];
      if (!hit.isEmpty()) {
        const bool begins = last == nullptr || std::abs(hit.distance - last->distance) > jump_;
        obstacle += begins ? 1 : 0;
        work(hit, obstacle, begins);
      }
      last = hit.isEmpty() ? nullptr : &hit;
    }
  }

 private:
  const SectorCircle& circle_;
  std::span<const SectorHit> hits_;
  double jump_;
};

/// Calls `work(edge of one obstacle, edge of the next)` for every gap between neighbours.
template <typename Work>
void forGaps(const Surroundings& around, const Work& work) {
  const SectorHit* last = nullptr;
  around.forPoints([&](const SectorHit& hit, int, bool begins) {
    if (begins && last != nullptr) work(last->point, hit.point);
    last = &hit;
  });
}

bool hasNarrowGap(const Surroundings& around, double widest) {
  bool narrow = false;
  forGaps(around, [&](Vec2 left, Vec2 right) { narrow = narrow || distance(left, right) < widest; });
  return narrow;
}

/// The number of the obstacle with the point nearest to `p`; -1 without any.
int obstacleAt(const Surroundings& around, Vec2 p) {
  int nearest = -1;
  double least = 1e300;
  around.forPoints([&](const SectorHit& hit, int obstacle, bool) {
    if (squaredNorm(hit.point - p) < least) least = squaredNorm(hit.point - p), nearest = obstacle;
  });
  return nearest;
}

bool touchesAnother(const Surroundings& around, const FrontOrbit& orbit, double radius) {
  const int first = obstacleAt(around, orbit.section.first),
            second = obstacleAt(around, orbit.section.second);
  const Vec2 centre = orbit.section.centre();
  bool touches = false;
  around.forPoints([&](const SectorHit& hit, int obstacle, bool) {
    const bool another = obstacle != first && obstacle != second;
    touches = touches || (another && std::abs(distance(hit.point, centre) - orbit.radius) < radius);
  });
  return touches;
}

}  // namespace

bool isCrowded(const SectorCircle& circle, std::span<const SectorHit> hits,
               const std::optional<FrontOrbit>& orbit, const CrowdingRule& rule) {
  const Surroundings around(circle, hits, rule.radius);
  return hasNarrowGap(around, rule.widest_gap) || (orbit && touchesAnother(around, *orbit, rule.radius));
}

}  // namespace fulbito
