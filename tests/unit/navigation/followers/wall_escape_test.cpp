#include "navigation/followers/wall_escape.hpp"

#include "fulbito/navigation.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"
#include "tests/support/kinematic_trial.hpp"

namespace fulbito {
namespace {

constexpr double kTouchingX = 0.75 - 0.0375, kTouchingY = 0.65 - 0.0375;
constexpr double kAside = 0.3;  // [m] off the middle, where the end wall has no goal mouth
constexpr Twist kSpin{0.0, 10.0};

double degrees(double angle) { return angle * math::kPi / 180.0; }

struct Stage {
  RobotModel robot = test::paperRobot(1.0);
  FieldGeometry field;
  std::vector<DiscObstacle> obstacles;
  NavigationScene scene;

  Stage(Pose2 pose, Vec2 goal) {
    scene.self.pose = pose;
    scene.goal.position = goal;
    scene.field = &field;
    scene.robot = &robot;
  }
  Twist apply(Twist wanted) {
    scene.obstacles = obstacles;
    return WallEscape().apply(scene, wanted);
  }
};

test::KinematicResult trial(const char* specification, double speed, Pose2 start, Vec2 goal) {
  auto pilot = makePilot(*parseNavigator(specification));
  REQUIRE(pilot);
  NavigationGoal target;
  target.position = goal;
  return test::kinematicTrial(**pilot, test::paperRobot(speed), {}, start, target, {}, 6.0);
}

}  // namespace

TEST_CASE("a robot that touches the wall it faces backs out, straight at first", "[unit]") {
  Stage stage({{kTouchingX, kAside}, 0.0}, {-0.4, 0.1});
  const Twist twist = stage.apply(kSpin);
  CHECK(twist.linear == Approx(-0.2 * 1.0));
  CHECK(twist.angular == 0.0);
}

TEST_CASE("a robot that backs out turns toward the goal as fast as it comes free", "[unit]") {
  Stage stage({{kTouchingX - 0.002, kAside}, 0.0}, {-0.4, 0.6});
  stage.scene.self.velocity = {-0.1, 0.0};
  const Twist twist = stage.apply(kSpin);
  CHECK(twist.linear < 0.0);
  CHECK(twist.angular == Approx(0.1 / stage.robot.circumradius()));
}

TEST_CASE("a robot with its back to the wall drives off forward", "[unit]") {
  Stage stage({{kTouchingX, kAside}, -math::kPi}, {0.7, -0.4});
  CHECK(stage.apply(kSpin).linear == Approx(0.2 * 1.0));
}

TEST_CASE("in a corner the inward diagonal is the normal", "[unit]") {
  // 70 degrees off the diagonal: more than a single wall's 50 degrees, and facing only one of the walls.
  const Pose2 pose{{-kTouchingX + 0.028, kTouchingY - 0.028}, degrees(135.0 + 70.0)};
  Stage stage(pose, {0.5, -0.4});
  CHECK(stage.apply(kSpin).linear == Approx(-0.2));
  stage.scene.self.pose.heading = degrees(-45.0 + 70.0);
  CHECK(stage.apply(kSpin).linear == Approx(0.2));
}

TEST_CASE("a robot along a wall, one that wants straight on and one with room are left alone", "[unit]") {
  const auto untouched = [](Pose2 pose, Twist wanted, double speed = 0.0) {
    Stage stage(pose, {-0.4, 0.1});
    stage.scene.self.velocity = math::unit(pose.heading) * speed;
    const Twist twist = stage.apply(wanted);
    return twist.linear == wanted.linear && twist.angular == wanted.angular;
  };
  CHECK(untouched({{kTouchingX, kAside}, degrees(90.0)}, {0.5, 2.0}));
  CHECK(untouched({{kTouchingX, kAside}, degrees(55.0)}, kSpin));
  CHECK(untouched({{kTouchingX, kAside}, 0.0}, {0.5, 0.3}));
  CHECK(untouched({{0.75 - 0.056, kAside}, 0.0}, kSpin));
  CHECK(untouched({{0.75 - 0.050, kAside}, 0.0}, {0.3, 3.0}, 0.3));
  CHECK_FALSE(untouched({{kTouchingX, kAside}, degrees(20.0)}, kSpin));
  CHECK(untouched({{kTouchingX, kAside}, degrees(20.0)}, {0.0, -2.0}));  // it turns out by itself
}

TEST_CASE("a goal's mouth is no wall and its back is", "[unit]") {
  Stage mouth({{kTouchingX, 0.0}, 0.0}, {-0.4, 0.1});
  CHECK(mouth.apply(kSpin).linear == 0.0);
  Stage back({{kTouchingX + 0.10, 0.0}, 0.0}, {-0.4, 0.1});
  CHECK(back.apply(kSpin).linear < 0.0);
}

TEST_CASE("an obstacle behind the robot keeps it from backing out", "[unit]") {
  Stage stage({{kTouchingX, kAside}, 0.0}, {-0.4, 0.1});
  stage.obstacles = {{{kTouchingX - 0.08, kAside}, 0.0335, {}}};
  CHECK(stage.apply(kSpin).linear == 0.0);
  stage.obstacles[0].position.x += 0.16;
  CHECK(stage.apply(kSpin).linear < 0.0);
}

TEST_CASE("an escape that does not get free gives way to the follower after a second", "[unit]") {
  Stage stage({{kTouchingX, kAside}, 0.0}, {-0.4, 0.1});
  WallEscape escape;
  int escaping = 0, following = 0;
  for (stage.scene.tick = 0; stage.scene.tick < 90; ++stage.scene.tick) {
    escape.apply(stage.scene, kSpin);
    ++(escape.active() ? escaping : following);
  }
  CHECK(escaping == Approx(61).margin(1));
  CHECK(following == Approx(29).margin(1));
}

TEST_CASE("robots at walls and in corners reach a goal elsewhere without pressing on the wall", "[unit]") {
  const Vec2 goals[] = {{-0.4, 0.1}, {0.5, -0.3}, {0.0, 0.5}};
  const double inset = 0.0375 * std::numbers::sqrt2;
  const Pose2 starts[] = {
      {{kTouchingX, kAside}, 0.0},
      {{kTouchingX, -kAside}, math::kPi},
      {{0.2, kTouchingY}, degrees(90.0)},
      {{0.2, -kTouchingY}, degrees(90.0)},
      // Flat against the corner triangle, whose middle is 3.5 cm from both walls.
      {{0.75 - 0.035 - 0.0375 / std::numbers::sqrt2, 0.65 - 0.035 - 0.0375 / std::numbers::sqrt2},
       degrees(45.0)},
      {{0.75 - 0.035 - inset, -0.65 + 0.035 + inset}, 0.0}};
  for (const char* navigator : {"straight", "straight:follower=classic", "tangent-field"}) {
    for (double speed : {0.6, 1.0, 2.6}) {
      for (const Pose2& start : starts) {
        for (Vec2 goal : goals) {
          const auto result = trial(navigator, speed, start, goal);
          INFO(navigator << " at " << speed << " m/s from " << start.position.x << ", " << start.position.y
                         << " heading " << start.heading << " to " << goal.x << ", " << goal.y);
          CHECK(result.reached);
          CHECK(result.min_clearance > -0.002);
        }
      }
    }
  }
}

TEST_CASE("a run that ends facing a wall is not disturbed", "[unit]") {
  const auto near = trial("straight", 1.0, {{0.0, kAside}, 0.0}, {0.70, kAside});
  CHECK(near.reached);
  const auto free = trial("straight", 1.0, {{-0.6, kAside}, 0.0}, {0.10, kAside});
  CHECK(near.time == free.time);
}

TEST_CASE("the escape can be switched off by every method", "[unit]") {
  Stage stage({{kTouchingX, kAside}, 0.0}, {-0.4, 0.1});
  stage.scene.obstacles = stage.obstacles;
  const auto first = [&](const char* specification) {
    auto pilot = makePilot(*parseNavigator(specification));
    REQUIRE(pilot);
    (*pilot)->reset();
    const WheelSpeeds wheels = (*pilot)->drive(stage.scene);
    return std::pair{wheels.left, wheels.right};
  };
  // The first command shows the escape.
  for (const std::string method : {"vector-field:follower=classic,", "bezier:"}) {
    const auto on = first((method + "wall_escape=on").c_str());
    CHECK(on != first((method + "wall_escape=off").c_str()));
  }
  CHECK(first("vector-field:follower=classic") == first("vector-field:follower=classic,wall_escape=on"));
  CHECK(parseNavigator("bezier:wall_escape=maybe").error().code == ErrorCode::kUsage);
}

}  // namespace fulbito
