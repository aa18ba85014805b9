#include "navigation/methods/hybrid/gap_sight.hpp"

#include <algorithm>
#include <limits>

#include "engine/core/models/sonar_model.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr double kNearby = 1.0;      // [m] farther gaps get no circles, at the paper's robot
constexpr double kPassable = 0.65;   // robot widths that the map shows of a gap of one width, at least
constexpr double kSpread = 1.0 / 3;  // of the guessed radius: its standard deviation
constexpr double kEverywhere = 1e3;  // [m]
constexpr std::size_t kReserve = 16;

EchoMap::Settings mapSettings(double memory) {
  EchoMap::Settings settings;
  settings.memory = memory;
  return settings;
}

/// Bodies in a robot's way are about as large as itself.
double usualRadius(const RobotModel& robot) { return (robot.width / 2 + robot.circumradius()) / 2; }

/// Into the body: away from the robot as well as from the gap's other edge.
Vec2 inward(Vec2 edge, Vec2 other) {
  constexpr Vec2 kAhead{1.0, 0.0};
  return unitOr(unitOr(edge, kAhead) + unitOr(edge - other, kAhead), kAhead);
}

}  // namespace

GapSight::GapSight(double memory) : map_(mapSettings(memory)), circles_({}) { gaps_.reserve(kReserve); }

void GapSight::reset() {
  map_.reset();
  circles_.reset();
  gaps_.clear();
}

void GapSight::look(const NavigationScene& scene, double widest, const SectorCircle& sectors,
                    std::span<SectorHit> hits) {
  map_.update(scene);
  circles_.update(scene);
  map_.scan(sectors, scene.self.pose, kEverywhere, circles_, hits);
  circles_.scan(sectors, scene.self.pose, hits);
  narrowGaps(sectors, hits, {scene.robot->circumradius(), widest}, gaps_);
  startEdges(scene);
}

void GapSight::startEdges(const NavigationScene& scene) {
  const Vec2 ahead = math::unit(scene.self.pose.heading);
  const double nearby = kNearby * pioneerScale(*scene.robot), radius = usualRadius(*scene.robot);
  for (const NarrowGap& gap : gaps_) {
    if (gap.width() < kPassable * scene.robot->width) continue;
    if (std::max(norm(gap.left), norm(gap.right)) > nearby) continue;
    for (const auto& [edge, other] : {std::pair{gap.left, gap.right}, std::pair{gap.right, gap.left}}) {
      EchoCircleStart start;
      start.surface = scene.self.pose.position + outOfFrame(ahead, edge);
      start.inward = outOfFrame(ahead, inward(edge, other));
      start.radius = radius;
      start.spread = kSpread * radius;
      circles_.start(start, scene.tick);
    }
  }
}

}  // namespace fulbito
