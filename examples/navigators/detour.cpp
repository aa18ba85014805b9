// Two navigators of your own in a shared library:
//   g++ -std=c++20 -O2 -shared -fPIC -fvisibility=hidden -I PREFIX/include detour.cpp -o detour.so
//   fulbito run --navigator ./detour.so:detour:margin=0.03 --layout corner:17
#include "fulbito/team.hpp"

using namespace fulbito::team;

namespace {

/// Drives straight to the goal, and around the first disc on the way.
class Detour : public Navigator {
 public:
  Detour() : Navigator("detour", "straight to the goal, round the first disc on the way", "example") {
    number("margin", margin_, 0.0, 0.2, "m", "room between the robot's corners and the disc");
  }
  void plan(const NavigationScene& scene, Guidance& guidance) override {
    guidance.kind = Guidance::Kind::kPath;
    guidance.path.assign({scene.self.position});
    if (const Disc* disc = firstInWay(scene)) guidance.path.push_back(beside(*disc, scene));
    guidance.path.push_back(scene.goal);
    guidance.revision = static_cast<std::uint64_t>(scene.tick) + 1;
  }

 private:
  /// Distance [m] that the robot's centre keeps from the centre of the disc.
  double room(const Disc& disc, const NavigationScene& scene) const {
    return disc.radius + scene.robot.circumradius() + margin_;
  }
  const Disc* firstInWay(const NavigationScene& scene) const {
    const Vec2 way = scene.goal - scene.self.position;
    const double length = std::hypot(way.x, way.y);
    const Disc* first = nullptr;
    double least = length;
    for (const Disc& disc : scene.obstacles) {
      const Vec2 to = disc.position - scene.self.position;
      const double along = (to.x * way.x + to.y * way.y) / length,
                   across = (way.x * to.y - way.y * to.x) / length;
      if (along > 0.0 && along < least && std::abs(across) < room(disc, scene)) least = along, first = &disc;
    }
    return first;
  }
  /// The place beside the disc, on the side where the straight line passes it.
  Vec2 beside(const Disc& disc, const NavigationScene& scene) const {
    const Vec2 way = scene.goal - scene.self.position, to = disc.position - scene.self.position;
    const double side = way.x * to.y - way.y * to.x > 0.0 ? -1.0 : 1.0;
    const double scale = side * room(disc, scene) / std::hypot(way.x, way.y);
    return disc.position + Vec2{-way.y * scale, way.x * scale};
  }

  double margin_ = 0.02;
};

/// A field of directions that all point to the goal.
class Homing : public Navigator {
 public:
  Homing() : Navigator("homing", "at the goal from everywhere", "example") {}
  void plan(const NavigationScene& scene, Guidance& guidance) override {
    guidance.kind = Guidance::Kind::kField;
    goal_ = scene.goal;
  }
  double heading(Vec2 p) const override { return std::atan2(goal_.y - p.y, goal_.x - p.x); }

 private:
  Vec2 goal_;
};

}  // namespace

FULBITO_NAVIGATORS(Detour, Homing)
