#include "navigation/obstacles/echo_map.hpp"

#include <cmath>
#include <vector>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

const RobotModel kRobot;

/// A robot at the origin with one sonar that points ahead.
class OneSonar {
 public:
  void hear(double range, int ticks) { take({{{0.0375, 0.0}, 0.0}, 0.218, 0.36, true, range}, ticks); }
  void silence(int ticks) { take({{{0.0375, 0.0}, 0.0}, 0.218, 0.36, false, 0.36}, ticks); }
  double nearest() {
    std::vector<SectorHit> hits(72);
    map_.scan(circle_, pose, 1.0, hits);
    double least = 1e9;
    for (const SectorHit& hit : hits) least = std::min(least, hit.distance);
    return least;
  }
  std::size_t discs() {
    std::vector<DiscObstacle> discs;
    map_.appendDiscs(discs);
    return discs.size();
  }
  Pose2 pose;

 private:
  void take(const RangeReading& reading, int ticks) {
    NavigationScene scene;
    scene.robot = &kRobot;
    scene.self.pose = pose;
    scene.ranges = {&reading, 1};
    for (int i = 0; i < ticks; ++i) {
      scene.tick = tick_++;
      map_.update(scene);
    }
  }
  EchoMap map_{EchoMap::Settings{}};
  SectorCircle circle_{72};
  Tick tick_ = 0;
};

}  // namespace

TEST_CASE("an echo becomes an obstacle at its range after some readings, not after one", "[unit]") {
  OneSonar robot;
  robot.hear(0.2, 1);
  CHECK(robot.nearest() > 1.0);
  robot.hear(0.2, 5);
  CHECK(robot.nearest() == Approx(0.2375).margin(0.012));
  CHECK(robot.discs() > 0);
}

TEST_CASE("farther echoes and silence clear what is nearer, but silence not what is close", "[unit]") {
  OneSonar robot;
  robot.hear(0.15, 10);
  robot.hear(0.3, 10);
  CHECK(robot.nearest() > 0.3);
  robot.silence(20);
  CHECK(robot.nearest() > 1.0);
  robot.hear(0.02, 10);
  robot.silence(20);
  CHECK(robot.nearest() < 0.08);
}

TEST_CASE("echoes stay where they are in the world while the robot turns and moves", "[unit]") {
  OneSonar robot;
  robot.hear(0.2, 10);
  robot.pose = {{0.05, 0.02}, 1.0};
  CHECK(robot.nearest() == Approx(norm(Vec2{0.2375 - 0.05, -0.02})).margin(0.012));
}

TEST_CASE("echoes are forgotten after the memory's time, and beyond the window", "[unit]") {
  OneSonar robot;
  robot.hear(0.2, 10);
  robot.pose.heading = math::kPi;  // the robot faces away
  robot.silence(115);
  CHECK(robot.nearest() < 0.3);
  robot.silence(10);
  CHECK(robot.nearest() > 1.0);
  OneSonar gone;
  gone.hear(0.2, 10);
  gone.pose = {{-0.5, 0.0}, math::kPi};
  gone.silence(1);
  gone.pose = {};
  CHECK(gone.nearest() > 1.0);
}
