#include <algorithm>
#include <cmath>

#include "engine/core/base/float_mode.hpp"
#include "experiments/trials/navigation_trial.hpp"
#include "experiments/trials/trial_recorder.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/experiment.hpp"

namespace fulbito {
namespace {

/// Returns the result of `work` and, with a clock, appends its duration [us] to `durations`.
template <typename Work>
auto timed(const Clock& now, std::vector<double>& durations, const Work& work) {
  if (!now) return work();
  const std::int64_t begin = now();
  auto value = work();
  durations.push_back(static_cast<double>(now() - begin) * 1e-3);
  return value;
}

void addTouches(std::span<const ContactEvent> contacts, double time, std::vector<Touch>& touches) {
  const auto solid = [](BodyId id) { return id.kind == BodyKind::kObstacle || id.kind == BodyKind::kWall; };
  const BodyId robot{BodyKind::kRobot, 0};
  for (const ContactEvent& event : contacts) {
    const bool its_own = (event.a == robot && solid(event.b)) || (event.b == robot && solid(event.a));
    if (event.began && its_own) touches.push_back({time, event.point});
  }
}

}  // namespace

void appendDiscs(const ObstacleSpec& spec, const ObstacleState& state, std::vector<DiscObstacle>& discs) {
  if (spec.shape == ObstacleShape::kDisc) {
    discs.push_back({state.pose.position, spec.radius, state.velocity});
    return;
  }
  const bool lengthwise = spec.length >= spec.width;
  const double longer = std::max(spec.length, spec.width), shorter = std::min(spec.length, spec.width);
  const Vec2 x = math::unit(state.pose.heading);
  const Vec2 axis = lengthwise ? x : perp(x);
  const int count = std::max(1, static_cast<int>(std::ceil(longer / shorter - 1e-9)));
  const double part = longer / count;
  const double radius = 0.5 * std::sqrt(part * part + shorter * shorter);
  for (int i = 0; i < count; ++i) {
    discs.push_back({state.pose.position + axis * ((i + 0.5) * part - longer / 2), radius, state.velocity});
  }
}

Result<TrialResult> runTrial(const TrialConfig& config, const Clock& clock, TrialRecorder* recorder) {
  const FloatMode floats;
  auto trial = NavigationTrial::create(config);
  if (!trial) return tl::unexpected<Error>(trial.error());
  auto pilot = makePilot(config.navigator);
  if (!pilot) return tl::unexpected<Error>(pilot.error());
  (*pilot)->reset();
  const WorldState& world = trial->world().state();
  TrialResult result;
  result.limit_path = trial->limitPath();
  if (recorder != nullptr) recorder->begins(world);
  result.trace.push_back({0.0, world.robots.front(), {}});
  while (!trial->over()) {
    const NavigationScene& scene = trial->observe();
    const WheelSpeeds wanted = timed(clock, result.compute_us, [&] { return (*pilot)->drive(scene); });
    if (recorder != nullptr) {
      recorder->planned((*pilot)->guidance(), scene.self.pose.position, scene.goal.position);
    }
    trial->step(wanted);
    const double time = trial->seconds();
    addTouches(trial->world().contacts(), time, result.touches);
    if (recorder != nullptr) recorder->ticked(world, trial->command(), trial->hash());
    result.trace.push_back({time, world.robots.front(), trial->command()});
  }
  result.score = trial->score();
  result.final_hash = trial->hash();
  if (recorder != nullptr) {
    if (auto written = recorder->ends(result); !written) return tl::unexpected<Error>(written.error());
  }
  return result;
}

}  // namespace fulbito
