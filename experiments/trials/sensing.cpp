#include "experiments/trials/sensing.hpp"

#include <algorithm>
#include <cmath>

#include "engine/core/math/math.hpp"

namespace fulbito {

Sensing::Sensing(const TrialConfig& config)
    : config_(config),
      dt_(config.physics.controlPeriod()),
      noise_(config.seed, Stream::kSensorNoise, config.index),
      sights_(static_cast<std::size_t>(config.sensors.latency_ticks) + 1),
      commands_(static_cast<std::size_t>(config.sensors.latency_ticks) + 1) {}

Sensing::Sight Sensing::look(const WorldState& world) {
  Sight sight{world.robots.front(), {}};
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    appendDiscs(config_.layout.obstacles[i], world.obstacles[i], sight.discs);
  }
  const double sigma = config_.sensors.position_noise;
  if (sigma > 0.0) {
    Pose2& pose = sight.robot.pose;
    pose.position += {noise_.normal(0.0, sigma), noise_.normal(0.0, sigma)};
    pose.heading =
        math::wrapAngle(pose.heading + noise_.normal(0.0, 2.0 * sigma / config_.robot.robot.length));
    for (DiscObstacle& disc : sight.discs)
      disc.position += {noise_.normal(0.0, sigma), noise_.normal(0.0, sigma)};
  }
  return sight;
}

void Sensing::observe(const WorldState& world) {
  sights_[seen_ % sights_.size()] = look(world);
  ++seen_;
  const std::size_t age = std::min(seen_, sights_.size()) - 1;
  const Sight& sight = sights_[(seen_ - 1 - age) % sights_.size()];
  robot_ = sight.robot;
  for (std::size_t k = age; k > 0; --k) {
    robot_ = rolledForward(config_.robot.robot, robot_, commands_[(given_ - k) % commands_.size()], dt_);
  }
  discs_ = sight.discs;
  for (DiscObstacle& disc : discs_) disc.position += disc.velocity * (static_cast<double>(age) * dt_);
}

void Sensing::commanded(WheelSpeeds command) {
  commands_[given_ % commands_.size()] = command;
  ++given_;
}

}  // namespace fulbito
