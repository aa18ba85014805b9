#include "navigation/obstacles/echo_circles.hpp"

#include <vector>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

const RobotModel kRobot;
constexpr Vec2 kDisc{0.2, 0.0};
constexpr double kRadius = 0.04;

/// A robot with one sonar at its centre that looks ahead.
class Listener {
 public:
  Listener() { circles.start({.surface = {0.165, 0.0}, .inward = {1.0, 0.0}}, 0); }
  /// Hears the disc, or nothing.
  void listen(int ticks, bool heard) {
    for (int i = 0; i < ticks; ++i) {
      scene.tick = ++tick_;
      scene.robot = &kRobot;
      reading_ = {{}, 0.218, 0.36, heard, heard ? kDisc.x - kRadius : 0.36};
      scene.ranges = {&reading_, 1};
      circles.update(scene);
    }
  }
  double nearest() {
    std::vector<SectorHit> hits(72, {std::numeric_limits<double>::infinity(), {}});
    circles.scan(SectorCircle(72), scene.self.pose, hits);
    double least = 1e9;
    for (const SectorHit& hit : hits) least = std::min(least, hit.distance);
    return least;
  }
  EchoCircles circles{EchoCircles::Settings{}};
  NavigationScene scene;

 private:
  RangeReading reading_;
  Tick tick_ = 0;
};

}  // namespace

TEST_CASE("a circle shows its surface once enough echoes say where it is", "[unit]") {
  Listener robot;
  CHECK(robot.nearest() > 1.0);
  robot.listen(30, true);
  CHECK(robot.nearest() == Approx(0.16).margin(0.003));
  CHECK(robot.circles.explains({0.152, 0.0}, 0.01));
  CHECK_FALSE(robot.circles.explains({0.145, 0.0}, 0.01));
}

TEST_CASE("a circle that is not heard where it should be goes", "[unit]") {
  Listener robot;
  robot.listen(30, true);
  robot.listen(11, false);
  CHECK(robot.circles.at({0.16, 0.0}) != nullptr);
  robot.listen(2, false);
  CHECK(robot.circles.at({0.16, 0.0}) == nullptr);
}

TEST_CASE("a circle that no sonar looks at is forgotten after the memory's time", "[unit]") {
  Listener robot;
  robot.listen(30, true);
  robot.scene.self.pose.heading = math::kPi;
  robot.listen(239, false);
  CHECK(robot.circles.named(1) != nullptr);
  robot.listen(3, false);
  CHECK(robot.circles.named(1) == nullptr);
}

TEST_CASE("ranges that do not fit leave a circle as it is", "[unit]") {
  Listener robot;
  robot.listen(30, true);
  const Vec2 before = robot.circles.named(1)->circle.centre();
  const RangeReading other{{}, 0.218, 0.36, true, 0.08};
  robot.scene.ranges = {&other, 1};
  robot.circles.update(robot.scene);
  CHECK(robot.circles.named(1)->circle.centre() == before);
}

TEST_CASE("one body gets one circle: none starts beside another, of twins the older stays", "[unit]") {
  Listener robot;
  robot.circles.start({.surface = {0.17, 0.02}, .inward = {1.0, 0.0}}, 0);
  CHECK(robot.circles.named(2) == nullptr);
  robot.circles.start({.surface = {0.13, 0.0}, .inward = {1.0, 0.0}, .radius = 0.001}, 0);
  CHECK(robot.circles.named(2) != nullptr);
  robot.circles.start({.surface = {0.145, -0.01}, .inward = {1.0, 0.0}, .radius = 0.1}, 0);
  robot.listen(1, true);
  CHECK(robot.circles.named(1) != nullptr);
  CHECK(robot.circles.named(3) == nullptr);
}
