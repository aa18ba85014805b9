#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/experiment.hpp"
#include "fulbito/sensors.hpp"
#include "navigation/obstacles/echo_map.hpp"

namespace fulbito {
namespace {

constexpr double kLargestFloor = 20.0;  // [m]

/// Eight front sonars with 5 % of drop-outs, echoes from smooth surfaces up to 30 degrees, and no cross-talk.
/// @param noise  [m] standard deviation of a range; 5 mm in the suites
SonarModel suiteSonars(const RobotModel& robot, double noise) {
  SonarModel model;
  model.sonars = frontSonars(robot);
  model.noise = noise;
  model.dropout = 0.05;
  return model;
}

}  // namespace

struct SonarSight::Impl {
  explicit Impl(const TrialConfig& config)
      : sonars(config.field, suiteSonars(config.robot.robot, config.sonar_noise),
               Rng(config.seed, Stream::kSonar, config.index)),
        plain(plainFloor("plain", kLargestFloor, kLargestFloor)),
        wants_discs(!config.navigator.info->reads_ranges),
        map({}) {}
  void look(const World& world, NavigationScene& scene);

  SonarArray sonars;
  FieldGeometry plain;
  bool wants_discs;
  EchoMap map;
  std::vector<RangeReading> readings;
  std::vector<DiscObstacle> discs;
};

SonarSight::SonarSight(const TrialConfig& config) : impl_(std::make_unique<Impl>(config)) {}
SonarSight::SonarSight(SonarSight&&) noexcept = default;
SonarSight& SonarSight::operator=(SonarSight&&) noexcept = default;
SonarSight::~SonarSight() = default;

void SonarSight::look(const World& world, NavigationScene& scene) { impl_->look(world, scene); }

void SonarSight::Impl::look(const World& world, NavigationScene& scene) {
  const auto heard = sonars.measure(world, 0);
  readings.clear();
  for (std::size_t i = 0; i < heard.size(); ++i) {
    const SonarSpec& sonar = sonars.model().sonars[i];
    readings.push_back({sonar.mount, sonar.half_cone, sonar.greatest, heard[i].heard, heard[i].range});
  }
  scene.field = &plain;
  scene.ranges = readings;
  discs.clear();
  if (wants_discs) {
    map.update(scene);
    map.appendDiscs(discs);
  }
  scene.obstacles = discs;
}

}  // namespace fulbito
