#include "navigation/methods/hybrid/hybrid.hpp"

#include <vector>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/navigator_properties.hpp"

using namespace fulbito;

namespace {

const FieldGeometry kWide{.name = "wide", .length = 16.0, .width = 16.0, .goal_width = 0.0, .corner = 0.0};
const RobotModel kRobot;

NavigationScene sceneWith(const std::vector<DiscObstacle>& discs, Tick tick = 0) {
  NavigationScene scene;
  scene.tick = tick;
  scene.field = &kWide;
  scene.robot = &kRobot;
  scene.goal.position = {1.0, 0.0};
  scene.obstacles = discs;
  return scene;
}

HybridMode modeAmong(Hybrid&& hybrid, const std::vector<DiscObstacle>& discs) {
  hybrid.reset();
  hybrid.plan(sceneWith(discs));
  return hybrid.mode();
}

const std::vector<DiscObstacle> kGap{{{0.2, 0.09}, 0.04, {}}, {{0.2, -0.09}, 0.04, {}}};
const std::vector<DiscObstacle> kAhead{{{0.25, 0.02}, 0.04, {}}};
const std::vector<DiscObstacle> kBeside{{{0.03, 0.20}, 0.04, {}}};

}  // namespace

TEST_CASE("hybrid: common properties", "[unit]") { test::checkNavigatorProperties("hybrid", {.scenes = 60}); }
TEST_CASE("hybrid-without-nd: common properties", "[unit]") {
  test::checkNavigatorProperties("hybrid-without-nd", {.scenes = 60});
}

TEST_CASE("hybrid: the situation chooses the behaviour", "[unit]") {
  CHECK(modeAmong(Hybrid(), {}) == HybridMode::kGoal);
  CHECK(modeAmong(Hybrid(), kAhead) == HybridMode::kAhead);
  CHECK(modeAmong(Hybrid(), kBeside) == HybridMode::kBeside);
  CHECK(modeAmong(Hybrid(), kGap) == HybridMode::kCrowded);
  CHECK(modeAmong(HybridWithoutNd(), kGap) == HybridMode::kAhead);
}

TEST_CASE("hybrid: passes an obstacle ahead on the side where the sonars show more room", "[unit]") {
  for (double y : {0.02, -0.02}) {
    Hybrid hybrid;
    hybrid.reset();
    hybrid.plan(sceneWith({{{0.25, y}, 0.04, {}}, {{0.1, y > 0.0 ? 0.33 : -0.33}, 0.05, {}}}));
    REQUIRE(hybrid.mode() == HybridMode::kAhead);
    CHECK(hybrid.heading({}) * y < 0.0);
  }
}

TEST_CASE("hybrid: keeps a behaviour for 0.2 s", "[unit]") {
  Hybrid hybrid;
  hybrid.reset();
  hybrid.plan(sceneWith(kAhead, 100));
  hybrid.plan(sceneWith({}, 111));  // 11 / 60 s later
  CHECK(hybrid.mode() == HybridMode::kAhead);
  hybrid.plan(sceneWith({}, 112));
  CHECK(hybrid.mode() == HybridMode::kGoal);
}

TEST_CASE("hybrid: what is farther than the goal is not in the way", "[unit]") {
  Hybrid hybrid;
  hybrid.reset();
  NavigationScene scene = sceneWith(kAhead);
  scene.goal.position = {0.15, 0.0};
  hybrid.plan(scene);
  CHECK(hybrid.mode() == HybridMode::kGoal);
}
