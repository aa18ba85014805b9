#include "navigation/library/library_navigator.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

const std::string kLibrary = FULBITO_TEST_LIBRARIES "/navigators.so";
const std::string kWrapped = FULBITO_TEST_LIBRARIES "/cpp_navigators.so";
const std::string kExample = FULBITO_TEST_LIBRARIES "/detour.so";

/// A robot at the origin that wants to stop half a metre ahead, near one obstacle.
struct Scene {
  Scene() {
    scene.goal.position = {0.5, 0.0};
    scene.goal.stop = true;
    scene.obstacles = {&obstacle, 1};
    scene.field = &field;
    scene.robot = &robot;
  }
  DiscObstacle obstacle{{0.2, 0.5}, 0.05, {}};
  FieldGeometry field;
  RobotModel robot;
  NavigationScene scene;
};

std::unique_ptr<Navigator> made(const std::string& name, const std::vector<Setting>& settings = {},
                                const std::string& library = kLibrary) {
  const auto choice = parseNavigator(library + ":" + name);
  REQUIRE(choice);
  return std::move(*choice->info->make(settings));
}

void checkRefused(const std::string& specification, ErrorCode code, const std::string& reason) {
  const auto choice = parseNavigator(specification);
  REQUIRE_FALSE(choice);
  CAPTURE(choice.error().message);
  CHECK(choice.error().code == code);
  CHECK(choice.error().message.find(reason) != std::string::npos);
}

}  // namespace

TEST_CASE("a specification names a navigator of a library with its own and the shared settings", "[unit]") {
  const auto choice = parseNavigator(kLibrary + ":path:gain=0.75,follower=classic,wall_escape=off");
  REQUIRE(choice);
  CHECK(choice->info->name == "path");
  CHECK(choice->info->summary == "for tests");
  CHECK(choice->info->parameters[0].unit == "m/s");
  CHECK(choice->classic_follower);
  CHECK(choice->wall_rule == WallRule::kNone);
  REQUIRE(choice->settings.size() == 1);
  CHECK(choice->settings[0].name == "gain");
  CHECK(parseNavigator(kLibrary + ":timed")->info->plans_speed);
}

TEST_CASE("each kind of guidance of a library reaches the pilot", "[unit]") {
  Scene s;
  auto navigator = made("field");
  Guidance guidance = navigator->plan(s.scene);
  REQUIRE(guidance.kind == GuidanceKind::kField);
  CHECK(guidance.field->heading({0.5, -1.0}) == Approx(1.5707963));
  navigator = made("path");
  s.scene.tick = 9;
  guidance = navigator->plan(s.scene);
  REQUIRE(guidance.kind == GuidanceKind::kPath);
  REQUIRE(guidance.path.size() == 3);
  CHECK(guidance.path[1] == Vec2{0.25, 0.0});
  CHECK(guidance.revision == 9);
  CHECK(std::isinf(guidance.speed_cap));
  navigator = made("timed", {{"gain", "0.75"}});
  guidance = navigator->plan(s.scene);
  REQUIRE(guidance.kind == GuidanceKind::kTimedPath);
  REQUIRE(guidance.speeds.size() == 3);
  CHECK(guidance.speeds[2] == 0.75);
  navigator = made("wheels");
  guidance = navigator->plan(s.scene);
  REQUIRE(guidance.kind == GuidanceKind::kWheels);
  CHECK(guidance.wheels.left == 0.5 / 0.026);
  CHECK(guidance.wheels.right == 1.0 + s.robot.wheel_radius + s.field.length);
}

TEST_CASE("guidance of a library that is not valid stops the robot", "[unit]") {
  Scene s;
  for (const std::string name : {"nan", "short", "unknown", "fails", "no-field"}) {
    CAPTURE(name);
    const auto navigator = made(name);
    for (int i = 0; i < 2; ++i) {
      const Guidance guidance = navigator->plan(s.scene);
      CHECK(guidance.kind == GuidanceKind::kWheels);
      CHECK(guidance.wheels.left == 0.0);
      CHECK(guidance.wheels.right == 0.0);
    }
  }
}

TEST_CASE("robots reach their goals by navigators of a library", "[unit]") {
  for (const std::string name : {"field", "path", "timed"}) {
    CAPTURE(name);
    const auto choice = parseNavigator(kLibrary + ":" + name);
    REQUIRE(choice);
    const auto pilot = makePilot(*choice);
    REQUIRE(pilot);
    Scene s;
    for (; s.scene.tick < 300; ++s.scene.tick) {
      const WheelSpeeds wheels = (*pilot)->drive(s.scene);
      s.scene.self = rolledForward(s.robot, s.scene.self, wheels, s.scene.dt);
    }
    CHECK(distance(s.scene.self.pose.position, {0.5, 0.0}) < 0.05);
  }
}

TEST_CASE("errors of a library's navigators name the library", "[unit]") {
  checkRefused(kLibrary + ":feld", ErrorCode::kUsage,
               "the library '" + kLibrary + "' has no navigator 'feld'; it has field, path");
  checkRefused(kLibrary + ":feld", ErrorCode::kUsage, "Did you mean 'field'?");
  checkRefused(kLibrary, ErrorCode::kUsage, "has no navigator ''");
  checkRefused(kLibrary + ":path:gian=1", ErrorCode::kUsage, "has no parameter 'gian'");
  checkRefused(kLibrary + ":path:gain=9", ErrorCode::kUsage, "is not a number from 0.1 to 2 m/s");
  checkRefused(kLibrary + ":refused", ErrorCode::kUsage, "refuses to be made: no licence");
  checkRefused(kLibrary + ":no-plan", ErrorCode::kBadInput, "navigator 'no-plan' lacks a function");
  checkRefused(FULBITO_TEST_LIBRARIES "/plain_c.so:x", ErrorCode::kUsage, "has no navigators");
  checkRefused("./no-such.so:x", ErrorCode::kIo, "cannot read the library './no-such.so'");
  checkRefused("no-such.so", ErrorCode::kIo, "No such file or directory");
}

TEST_CASE("a source that is not trusted cannot load a library", "[unit]") {
  const auto choice = parseBuiltInNavigator(kLibrary + ":path");
  REQUIRE_FALSE(choice);
  CHECK(choice.error().message.find("there is no navigator") == 0);
  CHECK(parseBuiltInNavigator("bezier:clearance=0.03"));
}

TEST_CASE("a choice keeps the library loaded", "[unit]") {
  std::unique_ptr<Pilot> pilot;
  {
    const auto choice = parseNavigator(kLibrary + ":path");
    REQUIRE(choice);
    pilot = std::move(*makePilot(*choice));
  }
  Scene s;
  CHECK(pilot->drive(s.scene).left > 0.0);
}

TEST_CASE("a navigator in C++ knows the scene, its settings and the robot's slip in curves", "[unit]") {
  Scene s;
  s.robot.curve_widening = 1.5;
  s.robot.curve_widening_rise = 0.25;
  s.scene.goal.heading = 0.5;
  const auto navigator = made("echo", {{"laps", "3"}}, kWrapped);
  navigator->reset();
  const Guidance guidance = navigator->plan(s.scene);
  REQUIRE(guidance.kind == GuidanceKind::kWheels);
  CHECK(guidance.wheels.left == Approx(1.5 + 2.5));
  CHECK(guidance.wheels.right == Approx(1.0 + 30.0 + 100.0 + 500.0));
  CHECK(guidance.speed_cap == 0.25);
  CHECK(parseNavigator(kWrapped + ":echo")->info->plans_speed);
  CHECK(parseNavigator(kWrapped + ":echo")->info->source == "none");
  s.scene.goal.heading.reset();
  CHECK(navigator->plan(s.scene).wheels.right == Approx(1.0 + 30.0 + 100.0));
}

TEST_CASE("a timed path in C++ needs a speed for each point; an exception stops the robot", "[unit]") {
  Scene s;
  const auto timed = made("timed", {}, kWrapped);
  const Guidance guidance = timed->plan(s.scene);
  REQUIRE(guidance.kind == GuidanceKind::kTimedPath);
  REQUIRE(guidance.path.size() == 2);
  CHECK(guidance.path[1] == Vec2{0.5, 0.0});
  CHECK(guidance.speeds[1] == 0.5);
  for (const char* wrong : {"short", "throwing"}) {
    const auto navigator = made(wrong, {}, kWrapped);
    const Guidance stopped = navigator->plan(s.scene);
    CHECK(stopped.kind == GuidanceKind::kWheels);
    CHECK(stopped.wheels.left == 0.0);
    CHECK(stopped.wheels.right == 0.0);
  }
}

TEST_CASE("the example's navigators: round the first disc on the way, and a field", "[unit]") {
  Scene s;
  const auto detour = made("detour", {{"margin", "0.03"}}, kExample);
  CHECK(detour->plan(s.scene).path.size() == 2);
  s.obstacle.position = {0.25, 0.02};
  const Guidance round = detour->plan(s.scene);
  REQUIRE(round.path.size() == 3);
  CHECK(round.path[1].x == Approx(0.25));
  CHECK(round.path[1].y == Approx(0.02 - 0.05 - s.robot.circumradius() - 0.03));
  const auto homing = made("homing", {}, kExample);
  const Guidance field = homing->plan(s.scene);
  REQUIRE(field.kind == GuidanceKind::kField);
  CHECK(field.field->heading({0.5, 0.5}) == Approx(-math::kPi / 2));
}

}  // namespace fulbito
