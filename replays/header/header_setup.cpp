#include "replays/header/header_setup.hpp"

#include <algorithm>

#include "replays/header/header_json.hpp"

namespace fulbito {
namespace {

constexpr double kLeastStep = 1e-6;  // [rad/s] finer steps do not fit into whole numbers

constexpr int kChunkSeconds = 6;
constexpr int kSampleRate = 30;  // [Hz]

double recordedCommandStep(const PhysicsProfile& physics) {
  return physics.wheel_command_step < kLeastStep ? 0.0 : physics.wheel_command_step;
}

}  // namespace

RecordingHeader headerFor(RecordingKind kind, const PhysicsProfile& physics) {
  RecordingHeader header;
  header.kind = kind;
  header.control_rate = physics.control_rate;
  header.command_step = recordedCommandStep(physics);
  header.sample_every = std::max(1, (physics.control_rate + kSampleRate / 2) / kSampleRate);
  header.chunk_ticks = std::min(kChunkSeconds * physics.control_rate, kMaxChunkTicks);
  header.build = buildInfo();
  return header;
}

}  // namespace fulbito
