#include "navigation/methods/hybrid/gap_sight.hpp"

#include <vector>

#include "engine/core/math/random.hpp"
#include "engine/core/models/echo_scene.hpp"
#include "engine/core/models/sonar_model.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

const RobotModel kRobot;
constexpr double kNoise = 0.005;

/// A robot that drives along the x axis toward a gap of 1.3 widths at x = 0, with eight noisy sonars.
class Drive {
 public:
  explicit Drive(std::uint64_t seed) : rng_(seed, Stream::kSonar) {
    for (double y : {0.08625, -0.08625}) world_.addDisc({0.0, y}, 0.0375);
  }
  void to(double x) {
    for (; at_ < x; at_ += 0.001) look();
  }
  /// Distance [m] from the x axis to the nearest thing on one side, +1 the left.
  double edge(double side) {
    double least = 1e9;
    for (const SectorHit& hit : hits_) {
      if (!hit.isEmpty() && hit.point.y * side > 0.0) least = std::min(least, std::abs(hit.point.y));
    }
    return least;
  }

 private:
  void look() {
    NavigationScene scene;
    scene.robot = &kRobot;
    scene.tick = tick_++;
    scene.self.pose = {{at_, 0.0}, 0.0};
    readings_.clear();
    for (const SonarSpec& sonar : frontSonars(kRobot)) {
      const Cone cone{scene.self.pose.position + sonar.mount.position, math::unit(sonar.mount.heading),
                      sonar.half_cone, sonar.greatest};
      const Echo echo = world_.castCone(cone, 0.5236);
      const bool heard = echo.isHeard();
      readings_.push_back({sonar.mount, sonar.half_cone, sonar.greatest, heard,
                           heard ? std::max(0.0, echo.distance + rng_.normal(0.0, kNoise)) : sonar.greatest});
    }
    scene.ranges = readings_;
    sight_.look(scene, 0.2, SectorCircle(72), hits_);
  }

  EchoScene world_;
  Rng rng_;
  GapSight sight_{2.0};
  std::vector<RangeReading> readings_;
  std::vector<SectorHit> hits_ = std::vector<SectorHit>(72);
  double at_ = -0.25;
  Tick tick_ = 0;
};

}  // namespace

TEST_CASE("the edges of a gap are seen to within 6 mm by sonars with 5 mm of noise", "[unit]") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Drive drive(seed);
    drive.to(-0.01);
    CHECK(drive.edge(1.0) == Approx(0.04875).margin(0.006));
    CHECK(drive.edge(-1.0) == Approx(0.04875).margin(0.006));
  }
}
