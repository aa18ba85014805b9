#include "replays/chunks/heard_state.hpp"

#include "replays/chunks/chunk_format.hpp"

namespace fulbito {

Pose2 asSampled(const RecordingHeader& header, const Pose2& pose) {
  const double step = header.sample_step;
  return {{wholeSteps(pose.position.x, step) * step, wholeSteps(pose.position.y, step) * step},
          headingSteps(pose.heading, header) * sampleHeadingStep(header)};
}

void standAt(const RecordingHeader& header, const std::vector<Pose2>& poses,
             std::span<const std::size_t> bodies, WorldState& state) {
  ++state.tick;
  state.robots.clear();
  state.balls.clear();
  state.obstacles.clear();
  for (const std::size_t body : bodies) {
    const Pose2& pose = poses[body];
    if (header.bodies[body].kind == BodyKind::kRobot) {
      state.robots.push_back({pose, {}, 0.0, {}});
    } else if (header.bodies[body].kind == BodyKind::kBall) {
      state.balls.push_back({pose.position, {}, {}});
    } else {
      state.obstacles.push_back({pose, {}});
    }
  }
}

}  // namespace fulbito
