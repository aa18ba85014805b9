#include "experiments/papers/localization/rig.hpp"

#include <span>
#include <utility>

#include "experiments/papers/random/streams.hpp"

namespace fulbito::localization {
namespace {

PhysicsProfile slowTicks() {
  PhysicsProfile physics;
  physics.control_rate = kControlRate;
  return physics;
}

}  // namespace

Result<Rig> Rig::create(const FieldGeometry& field, const Rover& rover, const Pose2& start, double celsius,
                        std::uint64_t seed, std::uint64_t index) {
  WorldConfig config;
  config.field = field;
  config.physics = slowTicks();
  const Vec2 centre{field.length / 2, field.width / 2};
  config.robots.push_back({rover.robot, {start.position - centre, start.heading}, {}, 0.0});
  auto world = World::create(config);
  if (!world) return tl::unexpected<Error>(world.error());
  return Rig(std::move(*world), field, rover, celsius, seed, index);
}

Rig::Rig(World world, const FieldGeometry& field, const Rover& rover, double celsius, std::uint64_t seed,
         std::uint64_t index)
    : rover_(rover),
      corner_{-field.length / 2, -field.width / 2},
      world_(std::move(world)),
      sonars_(field, rover.sonar, Rng(seed, kSonarStream, index)),
      encoders_(rover.encoders, rover.robot, Rng(seed, kEncoderStream, index)),
      gyro_(rover.gyro, Rng(seed, kGyroStream, index)),
      timer_(celsius) {}

InnerMotion Rig::step(Twist wanted) {
  const RobotState before = world_.state().robots.front();
  const WheelSpeeds command = inverseKinematics(rover_.robot, wanted);
  world_.step({&command, 1});
  const RobotState& after = world_.state().robots.front();
  const EncoderCounts counts = encoders_.read(before, after, kTick);
  const double turned = math::wrapAngle(after.pose.heading - before.pose.heading);
  return {static_cast<double>(counts.left + counts.right) / 2 * encoders_.metresPerCount(),
          gyro_.read(turned, kTick), kTick};
}

EchoTimes Rig::ping() {
  const std::span<const SonarReading> readings = sonars_.measure(world_, 0);
  EchoTimes times;
  for (std::size_t i = 0; i < times.size(); ++i) {
    // While a sensor still rings, it reports its least range, which is no echo.
    const bool heard = readings[i].heard && readings[i].range > rover_.sonar.sonars[i].least;
    if (heard) times[i] = static_cast<double>(timer_.microseconds(readings[i].range)) * 1e-6;
  }
  return times;
}

Pose2 Rig::truth() const {
  const Pose2& pose = world_.state().robots.front().pose;
  return {pose.position - corner_, pose.heading};
}

}  // namespace fulbito::localization
