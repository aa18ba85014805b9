#include "experiments/trials/sensing.hpp"

namespace fulbito {

Sensing::Sensing(const TrialConfig& config)
    : config_(config),
      dt_(config.physics.controlPeriod()),
      sensor_(config.sensors, Rng(config.seed, Stream::kSensorNoise, config.index)),
      sights_(config.sensors.latency_ticks),
      commands_(static_cast<std::size_t>(config.sensors.latency_ticks) + 1) {}

void Sensing::look(const WorldState& world) {
  const bool first = sights_.empty();  // at the start the robot knows all places
  last_.obstacles.resize(world.obstacles.size());
  if (first || sensor_.sees()) {
    last_.robot = world.robots.front();
    sensor_.blur(last_.robot.pose.position);
    sensor_.blurHeading(last_.robot.pose.heading);
  }
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (!first && !sensor_.sees()) continue;
    std::vector<DiscObstacle>& discs = last_.obstacles[i];
    discs.clear();
    appendDiscs(config_.layout.obstacles[i], world.obstacles[i], discs);
    for (DiscObstacle& disc : discs) sensor_.blur(disc.position);
  }
}

void Sensing::observe(const WorldState& world) {
  look(world);
  sights_.take(last_);
  const Sight& sight = sights_.shown();
  robot_ = sight.robot;
  for (std::size_t k = sights_.age(); k > 0; --k) {
    robot_ = rolledForward(config_.robot.robot, robot_, commands_[(given_ - k) % commands_.size()], dt_);
  }
  const double age = static_cast<double>(sights_.age()) * dt_;
  discs_.clear();
  for (const auto& obstacle : sight.obstacles) {
    for (DiscObstacle disc : obstacle) {
      disc.position += disc.velocity * age;
      discs_.push_back(disc);
    }
  }
}

void Sensing::commanded(WheelSpeeds command) {
  commands_[given_ % commands_.size()] = command;
  ++given_;
}

}  // namespace fulbito
