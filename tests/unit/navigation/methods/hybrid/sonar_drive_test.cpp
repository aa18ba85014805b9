#include "navigation/methods/hybrid/sonar_drive.hpp"

#include <algorithm>
#include <vector>

#include "engine/core/math/random.hpp"
#include "engine/core/models/shapes.hpp"
#include "fulbito/detail/echo_scene.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/detail/sonar_model.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

const RobotModel kRobot;
constexpr double kSpecular = 0.5236, kNoise = 0.005;  // [rad, m]

/// A robot that moves as it is told, with eight noisy sonars, before a doorway of 1.3 widths at x = 0.
class Doorway {
 public:
  explicit Doorway(SonarDrive& drive, std::uint64_t seed) : drive_(drive), rng_(seed, Stream::kSonar) {
    for (const double side : {1.0, -1.0})
      world_.addBody(cornersOf({{{0.0, side * 0.34875}, 0.0}, 0.04, 0.6}));
    scene_.robot = &kRobot;
    scene_.self.pose = {{-0.3, 0.05}, 0.1};
    scene_.goal.position = {0.3, 0.0};
    scene_.dt = 1.0 / 60;
    sonars_ = frontSonars(kRobot), readings_.resize(sonars_.size());
    drive_.reset();
  }
  /// Drives until the rear is through; allocations of the navigator are added to `count`.
  bool passes(std::uint64_t& count) {
    for (; scene_.tick < 1500 && scene_.self.pose.position.x < 0.1; ++scene_.tick) {
      listen();
      const std::uint64_t before = test::allocationCount();
      const Twist twist = drive_.drive(scene_);
      count += test::allocationCount() - before;
      Pose2& pose = scene_.self.pose;
      pose.position += math::unit(pose.heading) * (twist.linear * scene_.dt);
      pose.heading = math::wrapAngle(pose.heading + twist.angular * scene_.dt);
    }
    return scene_.self.pose.position.x >= 0.1;
  }

 private:
  void listen() {
    const Pose2& pose = scene_.self.pose;
    const Vec2 ahead = math::unit(pose.heading);
    for (std::size_t i = 0; i < sonars_.size(); ++i) {
      const SonarSpec& sonar = sonars_[i];
      const Cone cone{pose.position + outOfFrame(ahead, sonar.mount.position),
                      outOfFrame(ahead, math::unit(sonar.mount.heading)), sonar.half_cone, sonar.greatest};
      const Echo echo = world_.castCone(cone, kSpecular);
      const double range = std::max(0.0, echo.distance + rng_.normal(0.0, kNoise));
      readings_[i] = {sonar.mount, sonar.half_cone, sonar.greatest, echo.isHeard(),
                      echo.isHeard() ? range : sonar.greatest};
    }
    scene_.ranges = readings_;
  }

  SonarDrive& drive_;
  Rng rng_;
  EchoScene world_;
  NavigationScene scene_;
  std::vector<SonarSpec> sonars_;
  std::vector<RangeReading> readings_;
};

}  // namespace

TEST_CASE("by sonars a robot passes a doorway, and allocates nothing once warm", "[unit]") {
  SonarDrive drive;
  std::uint64_t first = 0, later = 0;
  CHECK(Doorway(drive, 41).passes(first));
  CHECK(first > 0);  // buffers grow
  CHECK(Doorway(drive, 42).passes(later));
  CHECK(later == 0);
}
