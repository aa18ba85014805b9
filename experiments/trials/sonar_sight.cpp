#include <vector>

#include "engine/core/math/random.hpp"
#include "fulbito/experiment.hpp"
#include "fulbito/sensors.hpp"
#include "navigation/obstacles/echo_map.hpp"

namespace fulbito {
namespace {

/// The largest field, without goals and corners.
FieldGeometry plainField() {
  FieldGeometry plain;
  plain.name = "plain";
  plain.length = plain.width = 20.0;
  plain.goal_width = plain.goal_depth = plain.corner = 0.0;
  return plain;
}

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
      : sonars_(config.field, suiteSonars(config.robot.robot, config.sonar_noise),
                Rng(config.seed, Stream::kSonar, config.index)),
        plain_(plainField()),
        wants_discs_(!config.navigator.info->reads_ranges),
        map_({}) {}
  void look(const World& world, NavigationScene& scene);

  SonarArray sonars_;
  FieldGeometry plain_;
  bool wants_discs_;
  EchoMap map_;
  std::vector<RangeReading> readings_;
  std::vector<DiscObstacle> discs_;
};

SonarSight::SonarSight(const TrialConfig& config) : impl_(std::make_unique<Impl>(config)) {}
SonarSight::SonarSight(SonarSight&&) noexcept = default;
SonarSight& SonarSight::operator=(SonarSight&&) noexcept = default;
SonarSight::~SonarSight() = default;

void SonarSight::look(const World& world, NavigationScene& scene) { impl_->look(world, scene); }

void SonarSight::Impl::look(const World& world, NavigationScene& scene) {
  const auto heard = sonars_.measure(world, 0);
  readings_.clear();
  for (std::size_t i = 0; i < heard.size(); ++i) {
    const SonarSpec& sonar = sonars_.model().sonars[i];
    readings_.push_back({sonar.mount, sonar.half_cone, sonar.greatest, heard[i].heard, heard[i].range});
  }
  scene.field = &plain_;
  scene.ranges = readings_;
  discs_.clear();
  if (wants_discs_) {
    map_.update(scene);
    map_.appendDiscs(discs_);
  }
  scene.obstacles = discs_;
}

}  // namespace fulbito
