#include "navigation/methods/hybrid/strip_guide.hpp"

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

const RobotModel kRobot;

/// A passage of 1.3 robot widths along the x axis, from x = 0.1 to `end`.
class Passage {
 public:
  explicit Passage(double end = 0.14) {
    scene.robot = &kRobot;
    scene.goal.position = {0.27, 0.0};
    map.centre({}, 0);
    for (double x = 0.1; x <= end; x += 0.005) {
      for (const double side : {1.0, -1.0}) put({x, side * 0.0525}, side);
    }
    for (double y = 0.055; y < 0.33; y += 0.005) face(y), face(-y);
    // Sensors looked through: the faces do not go on there.
    for (double y = -0.045; y <= 0.045; y += 0.005) map.takeIn({{0.0, y}, {1.0, 0.0}, 0.05, false, 0.3}, 1.0);
  }
  /// What the guide does at `pose`, with what the front corners' sonars hear.
  std::optional<Twist> drive(const Pose2& pose, std::optional<double> left = {},
                             std::optional<double> right = {}) {
    scene.self.pose = pose, ++scene.tick;
    map.centre(pose.position, scene.tick);
    way.search(map, pose.position, scene.goal.position, kRobot.width / 2);
    room.look(scene, map, {});
    return guide.drive({scene, map, way, room, bodySize(kRobot), left, right});
  }
  bool leads(const Pose2& pose) { return drive(pose), guide.isActive(); }
  StripGuide guide;

 private:
  void put(Vec2 place, double side) {
    for (int i = 0; i < 4; ++i)
      map.takeIn({place - Vec2{0.0, side * 0.03}, {0.0, side}, 0.1, true, 0.03}, 1.0);
  }
  void face(double y) {
    for (int i = 0; i < 4; ++i) map.takeIn({{0.04, y}, {1.0, 0.0}, 0.1, true, 0.06}, 1.0);
  }

  NavigationScene scene;
  ProvenMap map{0.005};
  WaySearch way;
  BodyRoom room;
};

}  // namespace

TEST_CASE("the guide begins before a narrow place only, and on its axis", "[unit]") {
  CHECK(Passage().leads({{0.02, 0.0}, 0.1}));
  CHECK_FALSE(Passage().leads({{0.02, 0.06}, 0.0}));  // too far aside
  CHECK_FALSE(Passage().leads({{-0.25, 0.0}, 0.0}));  // too early
  CHECK_FALSE(Passage().leads({{0.02, 0.0}, 1.3}));   // turned away
  CHECK_FALSE(Passage().leads({{0.25, 0.0}, 0.0}));   // past it
}

TEST_CASE("the guide leads until the rear corners are out of the last thing beside", "[unit]") {
  for (const double end : {0.14, 0.19, 0.26}) {
    Passage passage(end);
    REQUIRE(passage.leads({{0.02, 0.0}, 0.0}));
    double x = 0.02;
    while (x < 0.5 && passage.leads({{x, 0.0}, 0.0})) x += 0.004;
    const double rear = x - kRobot.length / 2;
    INFO(end);
    CHECK(rear > end);
    CHECK(rear < end + 0.035);
  }
}

TEST_CASE("a side that a front corner's sonar hears near turns the robot away, and stops it before a touch",
          "[unit]") {
  const Pose2 inside{{0.09, 0.0}, 0.0};
  const auto twist = [&](std::optional<double> left, std::optional<double> right) {
    Passage passage;
    REQUIRE(passage.leads({{0.02, 0.0}, 0.0}));
    const auto wanted = passage.drive(inside, left, right);
    REQUIRE(wanted);
    return *wanted;
  };
  const Twist middle = twist(0.015, 0.015), left = twist(0.007, {}), right = twist({}, 0.007);
  CHECK(std::abs(middle.angular) < 0.1);
  CHECK(middle.linear > 0.0);
  CHECK(left.angular < -0.1);
  CHECK(left.linear > 0.0);
  CHECK(right.angular > 0.1);
  CHECK(twist(0.02, 0.007).angular > 0.1);
  CHECK(twist(0.003, {}).linear < 0.0);
  CHECK(twist({}, 0.003).linear < 0.0);
}
