#include "replays/header/header_setup.hpp"

#include <algorithm>
#include <cmath>

#include "replays/header/header_json.hpp"

namespace fulbito {
namespace {

constexpr double kLeastStep = 1e-6;  // [rad/s]
constexpr double kMostModel = 1e9;   // of what a header may say

constexpr int kChunkSeconds = 6;
constexpr int kSampleRate = 30;  // [Hz]

double recordedCommandStep(const PhysicsProfile& physics) {
  return physics.wheel_command_step < kLeastStep ? 0.0 : physics.wheel_command_step;
}

CommandModel commandModel(const RobotModel& robot, const PhysicsProfile& physics) {
  CommandModel model;
  if (recordedCommandStep(physics) == 0.0) return model;
  const double steps = 1.0 / (robot.wheel_radius * physics.wheel_command_step);  // of a wheel for 1 m/s
  const auto whole = [](double value) {
    return static_cast<int>(std::lround(std::clamp(value, 0.0, kMostModel)));
  };
  model.most_change = whole(2.0 * robot.wheel_acceleration * physics.controlPeriod() * steps);
  if (robot.spin_slow_speed <= 0.0) return model;
  model.spin_from = whole(2.0 * robot.spin_slow_speed * steps);
  model.spin_to = std::max(model.spin_from, whole(2.0 * robot.spin_fast_speed * steps));
  model.spin_slow = std::min(whole(65536.0 * robot.spin_slow_ratio), 2 * 65536);
  model.spin_fast = std::min(whole(65536.0 * robot.spin_fast_ratio), 2 * 65536);
  return model;
}

}  // namespace

RecordingHeader headerFor(RecordingKind kind, const RobotModel& robot, const PhysicsProfile& physics) {
  RecordingHeader header;
  header.kind = kind;
  header.control_rate = physics.control_rate;
  header.command_step = recordedCommandStep(physics);
  header.command_model = commandModel(robot, physics);
  header.sample_every = std::max(1, (physics.control_rate + kSampleRate / 2) / kSampleRate);
  header.chunk_ticks = std::min(kChunkSeconds * physics.control_rate, kMaxChunkTicks);
  header.build = buildInfo();
  return header;
}

}  // namespace fulbito
