#include <array>
#include <cmath>

#include "fulbito/navigation.hpp"
#include "navigation/followers/preview_follower.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::test {
namespace {

/// Drives straight to the goal.
class Straight final : public Navigator {
 public:
  void reset() override {}
  Guidance plan(const NavigationScene& scene) override {
    path_ = {scene.self.pose.position, scene.goal.position};
    Guidance guidance;
    guidance.kind = GuidanceKind::kPath;
    guidance.path = path_;
    guidance.revision = ++revision_;
    return guidance;
  }

 private:
  std::array<Vec2, 2> path_;
  std::uint64_t revision_ = 0;
};

/// Commands wheel speeds that no motor reaches.
class Reckless final : public Navigator {
 public:
  void reset() override {}
  Guidance plan(const NavigationScene&) override {
    Guidance guidance;
    guidance.kind = GuidanceKind::kWheels;
    guidance.wheels = {1e6, -1e6};
    return guidance;
  }
};

struct Scene {
  FieldGeometry field;
  RobotModel robot;
  NavigationScene scene;
  Scene() {
    scene.field = &field;
    scene.robot = &robot;
    scene.goal.position = {0.3, 0.2};
  }
};

}  // namespace

TEST_CASE("a pilot without a follower drives with the one that all methods share", "[unit]") {
  Scene at;
  Pilot plain(std::make_unique<Straight>());
  Pilot given(std::make_unique<Straight>(), std::make_unique<PreviewFollower>());
  for (at.scene.tick = 0; at.scene.tick < 30; ++at.scene.tick) {
    const WheelSpeeds a = plain.drive(at.scene), b = given.drive(at.scene);
    CHECK(a.left == b.left);
    CHECK(a.right == b.right);
    CHECK(std::abs(a.left) + std::abs(a.right) > 0.0);
    at.scene.self = rolledForward(at.robot, at.scene.self, a, at.scene.dt);
  }
  CHECK(distance(at.scene.self.pose.position, at.scene.goal.position) < 0.3);
}

TEST_CASE(
    "wheel speeds of a method that drives itself are limited to what "
    "motors reach",
    "[unit]") {
  Scene at;
  Pilot pilot(std::make_unique<Reckless>());
  const WheelSpeeds wheels = pilot.drive(at.scene);
  CHECK(wheels.left == at.robot.max_wheel_speed);
  CHECK(wheels.right == -at.robot.max_wheel_speed);
  CHECK(pilot.guidance().kind == GuidanceKind::kWheels);
}

}  // namespace fulbito::test
