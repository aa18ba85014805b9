#include "navigation/followers/preview_follower.hpp"

#include <array>

#include "fulbito/detail/math.hpp"
#include "navigation/followers/path_tracker.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"

namespace fulbito {
namespace {

const FieldGeometry kField;
const RobotModel kRobot = test::paperRobot(2.6);

NavigationScene sceneAt(Pose2 pose, double speed) {
  NavigationScene scene;
  scene.field = &kField;
  scene.robot = &kRobot;
  scene.self.pose = pose;
  scene.self.velocity = math::unit(pose.heading) * speed;
  scene.goal.position = {0.5, 0.0};
  return scene;
}

Guidance timedLine(std::span<const Vec2> path, std::span<const double> speeds) {
  Guidance guidance;
  guidance.kind = GuidanceKind::kTimedPath;
  guidance.path = path;
  guidance.speeds = speeds;
  guidance.revision = 1;
  return guidance;
}

constexpr std::array<Vec2, 3> kLine{{{-0.5, 0.0}, {0.0, 0.0}, {0.5, 0.0}}};
constexpr std::array<double, 3> kSpeeds{1.0, 1.0, 1.0};

}  // namespace

TEST_CASE("a timed path is driven at its speeds and straight ahead on it", "[unit]") {
  PreviewFollower follower;
  const Twist wanted = follower.follow(timedLine(kLine, kSpeeds), sceneAt({{-0.3, 0.0}, 0.0}, 1.0));
  CHECK(wanted.linear == Approx(1.0));
  CHECK(wanted.angular == Approx(0.0).margin(1e-12));
}

TEST_CASE("a robot beside its path steers back to it", "[unit]") {
  PreviewFollower follower;
  CHECK(follower.follow(timedLine(kLine, kSpeeds), sceneAt({{-0.3, 0.02}, 0.0}, 1.0)).angular < 0.0);
  CHECK(follower.follow(timedLine(kLine, kSpeeds), sceneAt({{-0.3, -0.02}, 0.0}, 1.0)).angular > 0.0);
}

TEST_CASE("a start that faces away turns in place", "[unit]") {
  PreviewFollower follower;
  const Twist wanted = follower.follow(timedLine(kLine, kSpeeds), sceneAt({{-0.3, 0.0}, 1.2}, 0.0));
  CHECK(wanted.linear == 0.0);
  CHECK(wanted.angular < 0.0);
}

TEST_CASE("a slow robot at a goal with a heading turns to it in place, a fast one does not", "[unit]") {
  NavigationScene slow = sceneAt({{0.49, 0.0}, 0.0}, 0.02), fast = sceneAt({{0.49, 0.0}, 0.0}, 1.0);
  slow.goal.heading = fast.goal.heading = 0.8;
  PreviewFollower follower;
  const Twist turn = follower.follow(timedLine(kLine, kSpeeds), slow);
  CHECK(turn.linear == 0.0);
  CHECK(turn.angular == Approx(8.0));
  CHECK(follower.follow(timedLine(kLine, kSpeeds), fast).linear > 0.5);
}

TEST_CASE("a speed cap below the robot's speed leaves wheel acceleration for braking", "[unit]") {
  Guidance guidance = timedLine(kLine, kSpeeds);
  NavigationScene scene = sceneAt({{-0.3, 0.0}, 0.7}, 1.0);
  PreviewFollower open, capped;
  const double free_yaw = std::abs(open.follow(guidance, scene).angular);
  guidance.speed_cap = 0.0;
  const Twist wanted = capped.follow(guidance, scene);
  const double most = 2.0 * kRobot.wheel_acceleration * scene.dt / kRobot.axle_track;
  CHECK(wanted.linear == 0.0);
  CHECK(free_yaw > most);
  CHECK(std::abs(wanted.angular) < 0.5 * most);
}

TEST_CASE("the path tracker holds on to its place where the path crosses itself", "[unit]") {
  // A figure of eight through the origin with points 2 cm apart.
  std::vector<Vec2> path;
  for (int i = 0; i <= 100; ++i) {
    const math::SinCos sc = math::sinCos(2.0 * math::kPi * i / 100.0);
    path.push_back({0.5 * sc.sin, 0.5 * sc.sin * sc.cos});
  }
  PathTracker tracker;
  for (std::size_t i = 0; i <= 50; i += 2) {
    const PathPlace place = tracker.locate(path, 7, path[i]);
    CHECK(static_cast<double>(place.segment) + place.fraction == Approx(static_cast<double>(i)).margin(1.0));
  }
  CHECK(tracker.locate(path, 7, {0.0, 0.0}).segment >= 49);
}

TEST_CASE("advancing along a path crosses its vertices and ends at its end", "[unit]") {
  const PathPlace place = advance(kLine, {0, 0.5}, 0.5);
  CHECK(distance(pointAt(kLine, place), {0.25, 0.0}) < 1e-12);
  CHECK(distance(pointAt(kLine, advance(kLine, {0, 0.0}, 9.0)), {0.5, 0.0}) < 1e-12);
}

}  // namespace fulbito
