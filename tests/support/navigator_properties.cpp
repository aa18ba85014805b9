#include "tests/support/navigator_properties.hpp"

#include <bit>
#include <cmath>
#include <memory>
#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/navigation.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito::test {
namespace {

constexpr int kRandomTicks = 20;

/// A scene that owns what a NavigationScene views.
struct OwnedScene {
  std::string name;
  RobotState self;
  NavigationGoal goal;
  std::vector<DiscObstacle> obstacles;
  FieldGeometry field;
  RobotModel robot;

  NavigationScene view(Tick tick) const {
    NavigationScene scene;
    scene.tick = tick;
    scene.self = self;
    scene.goal = goal;
    scene.obstacles = obstacles;
    scene.field = &field;
    scene.robot = &robot;
    return scene;
  }

  /// Moves the robot as the wheels say, without slip, and the obstacles as their velocities say.
  void step(WheelSpeeds wheels, double dt) {
    const Twist twist = forwardKinematics(robot, wheels);
    self.pose.heading = math::wrapAngle(self.pose.heading + twist.angular * dt);
    self.velocity = math::unit(self.pose.heading) * twist.linear;
    self.angular_velocity = twist.angular;
    self.wheels = wheels;
    self.pose.position += self.velocity * dt;
    for (DiscObstacle& o : obstacles) o.position += o.velocity * dt;
  }
};

OwnedScene namedScene(std::string name, Pose2 start, Vec2 goal, std::vector<DiscObstacle> obstacles) {
  OwnedScene scene;
  scene.name = std::move(name);
  scene.self.pose = start;
  scene.goal.position = goal;
  scene.obstacles = std::move(obstacles);
  return scene;
}

OwnedScene randomScene(std::uint64_t seed, int obstacles, double speed) {
  Rng rng(seed, kTestStream, 77);
  const auto place = [&rng] { return Vec2{rng.uniform(-0.68, 0.68), rng.uniform(-0.58, 0.58)}; };
  OwnedScene scene = namedScene("random scene " + std::to_string(seed), {}, place(), {});
  scene.self.pose = {place(), rng.uniform(-3.1, 3.1)};
  scene.self.velocity = math::unit(scene.self.pose.heading) * rng.uniform(0.0, 0.8);
  scene.self.angular_velocity = rng.uniform(-5.0, 5.0);
  if (rng.below(2) == 1) scene.goal.heading = rng.uniform(-3.1, 3.1);
  scene.goal.stop = rng.below(2) == 1;
  for (int i = 0; i < obstacles; ++i) {
    scene.obstacles.push_back(
        {place(), rng.uniform(0.02, 0.06), {rng.uniform(-speed, speed), rng.uniform(-speed, speed)}});
  }
  return scene;
}

OwnedScene randomScene(std::uint64_t seed) {
  return randomScene(seed, static_cast<int>(seed % 9), seed % 3 == 0 ? 0.5 : 0.0);
}

std::vector<OwnedScene> degenerateScenes() {
  const double r = 0.0335, wall_x = 0.75 - 0.0375, wall_y = 0.65 - 0.0375;
  const Pose2 start{{-0.4, 0.1}, 0.3};
  const Vec2 goal{0.5, 0.2};
  std::vector<OwnedScene> scenes = {
      namedScene("no obstacle", start, goal, {}),
      namedScene("goal inside an obstacle", start, goal, {{goal + Vec2{0.01, 0.0}, r, {}}}),
      namedScene("goal on an obstacle's centre", start, goal, {{goal, r, {}}}),
      namedScene("robot on the goal", {goal, 1.0}, goal, {{{0.0, 0.0}, r, {}}}),
      namedScene("robot and obstacle on the goal", {goal, 1.0}, goal, {{goal, r, {}}}),
      namedScene("robot on an obstacle's centre", start, goal, {{start.position, r, {}}}),
      namedScene("coincident obstacles", start, goal, {{{0.0, 0.15}, r, {}}, {{0.0, 0.15}, r, {}}}),
      namedScene("obstacle exactly on the line", {{-0.4, 0.0}, 0.0}, {0.4, 0.0}, {{{0.0, 0.0}, r, {}}}),
      namedScene("obstacle without a size", start, goal, {{{0.0, 0.15}, 0.0, {}}}),
      namedScene("obstacle as large as the field", start, goal, {{{0.1, 0.1}, 0.9, {}}}),
      namedScene("robot facing a wall that it touches", {{wall_x, 0.1}, 0.0}, {-0.4, 0.1}, {}),
      namedScene("robot facing a corner", {{wall_x, wall_y}, 0.785}, {-0.4, 0.1}, {{{0.5, 0.4}, r, {}}}),
      namedScene("robot beyond the wall", {{0.9, 0.9}, 0.785}, {-0.4, 0.1}, {}),
      namedScene("goal outside the field", start, {1.5, 2.0}, {{{0.1, 0.2}, r, {}}}),
      namedScene("goal in the goal's mouth", start, {0.8, 0.0}, {{{0.6, 0.0}, r, {}}}),
      namedScene("obstacle overtaking", start, goal, {{{-0.6, 0.1}, r, {1.5, 0.0}}}),
      namedScene("obstacle coming", start, goal, {{{0.1, 0.15}, r, {-1.5, 0.0}}}),
      randomScene(1001, 50, 0.0),
      randomScene(1002, 50, 1.0),
  };
  const std::size_t count = scenes.size();
  for (std::size_t i = 0; i < count; ++i) {
    OwnedScene posture = scenes[i];
    posture.name += posture.goal.heading ? ", any arrival" : ", arrival heading wanted";
    posture.goal.heading = posture.goal.heading ? std::optional<double>{} : 2.0;
    scenes.push_back(std::move(posture));
  }
  return scenes;
}

bool finiteField(const HeadingField& field, const OwnedScene& scene) {
  bool finite = std::isfinite(field.heading(scene.self.pose.position)) &&
                std::isfinite(field.heading(scene.goal.position)) &&
                std::isfinite(field.heading({9.0, -9.0}));
  for (const DiscObstacle& o : scene.obstacles) finite = finite && std::isfinite(field.heading(o.position));
  return finite;
}

bool finitePath(const Guidance& guidance) {
  bool finite = guidance.path.size() >= 2;
  for (Vec2 p : guidance.path) finite = finite && isFinite(p);
  if (guidance.kind != GuidanceKind::kTimedPath) return finite;
  finite = finite && guidance.speeds.size() == guidance.path.size();
  for (double v : guidance.speeds) finite = finite && std::isfinite(v) && v >= 0.0;
  return finite;
}

bool soundGuidance(const Guidance& guidance, const OwnedScene& scene) {
  if (std::isnan(guidance.speed_cap) || guidance.speed_cap < 0.0) return false;
  if (guidance.kind == GuidanceKind::kWheels) {
    return std::isfinite(guidance.wheels.left) && std::isfinite(guidance.wheels.right);
  }
  if (guidance.kind == GuidanceKind::kField) {
    return guidance.field != nullptr && finiteField(*guidance.field, scene);
  }
  return finitePath(guidance);
}

bool withinSaturation(const RobotModel& robot, WheelSpeeds wheels) {
  // Comparisons with NaN are false.
  return std::abs(wheels.left) <= robot.max_wheel_speed && std::abs(wheels.right) <= robot.max_wheel_speed;
}

std::unique_ptr<Pilot> makeOrFail(const NavigatorChoice& choice) {
  auto pilot = makePilot(choice);
  REQUIRE(pilot);
  return std::move(*pilot);
}

void checkSound(Pilot& pilot, OwnedScene scene, int ticks) {
  pilot.reset();
  for (int tick = 0; tick < ticks; ++tick) {
    const NavigationScene view = scene.view(tick);
    const WheelSpeeds wheels = pilot.drive(view);
    INFO(scene.name << ", tick " << tick << ": wheels " << wheels.left << ", " << wheels.right);
    REQUIRE(withinSaturation(scene.robot, wheels));
    REQUIRE(soundGuidance(pilot.guidance(), scene));
    scene.step(wheels, view.dt);
  }
}

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

void checkSameBits(Pilot& one, Pilot& other, OwnedScene scene) {
  one.reset();
  other.reset();
  for (int tick = 0; tick < kRandomTicks; ++tick) {
    const NavigationScene view = scene.view(tick);
    const WheelSpeeds a = one.drive(view), b = other.drive(view);
    INFO(scene.name << ", tick " << tick);
    REQUIRE(bits(a.left) == bits(b.left));
    REQUIRE(bits(a.right) == bits(b.right));
    scene.step(a, view.dt);
  }
}

OwnedScene turned(OwnedScene scene) {
  scene.self.pose.position = -scene.self.pose.position;
  scene.self.pose.heading = math::wrapAngle(scene.self.pose.heading + math::kPi);
  scene.self.velocity = -scene.self.velocity;
  scene.goal.position = -scene.goal.position;
  if (scene.goal.heading) scene.goal.heading = math::wrapAngle(*scene.goal.heading + math::kPi);
  for (DiscObstacle& o : scene.obstacles) o.position = -o.position, o.velocity = -o.velocity;
  return scene;
}

void checkHalfTurn(Pilot& pilot, const OwnedScene& scene) {
  pilot.reset();
  const WheelSpeeds plain = pilot.drive(scene.view(0));
  pilot.reset();
  const OwnedScene other = turned(scene);
  const WheelSpeeds rotated = pilot.drive(other.view(0));
  INFO(scene.name << ": " << plain.left << ", " << plain.right << " against " << rotated.left << ", "
                  << rotated.right);
  REQUIRE(std::abs(plain.left - rotated.left) <= 1e-9 * scene.robot.max_wheel_speed);
  REQUIRE(std::abs(plain.right - rotated.right) <= 1e-9 * scene.robot.max_wheel_speed);
}

/// Heap allocations of one run over the random scenes, scene keeping not counted.
std::uint64_t allocationsOfRun(Pilot& pilot, int scenes) {
  std::uint64_t inside = 0;
  for (int seed = 0; seed < scenes; ++seed) {
    OwnedScene scene = randomScene(static_cast<std::uint64_t>(seed));
    pilot.reset();
    for (int tick = 0; tick < kRandomTicks; ++tick) {
      const NavigationScene view = scene.view(tick);
      const std::uint64_t before = allocationCount();
      const WheelSpeeds wheels = pilot.drive(view);
      inside += allocationCount() - before;
      scene.step(wheels, view.dt);
    }
  }
  return inside;
}

}  // namespace

void checkNavigatorProperties(const std::string& specification, NavigatorProperties properties) {
  INFO(specification);
  const auto choice = parseNavigator(specification);
  REQUIRE(choice);
  // One pilot goes through all scenes, so that what a reset forgets to clear shows up against a fresh one.
  const std::unique_ptr<Pilot> pilot = makeOrFail(*choice);
  for (const OwnedScene& scene : degenerateScenes()) checkSound(*pilot, scene, properties.edge_ticks);
  for (int seed = 0; seed < properties.scenes; ++seed) {
    const OwnedScene scene = randomScene(static_cast<std::uint64_t>(seed));
    checkSound(*pilot, scene, kRandomTicks);
    const std::unique_ptr<Pilot> fresh = makeOrFail(*choice);
    checkSameBits(*pilot, *fresh, scene);
    if (properties.half_turn) checkHalfTurn(*pilot, scene);
  }
  if (!properties.allocates) REQUIRE(allocationsOfRun(*pilot, properties.scenes) == 0);
}

}  // namespace fulbito::test
