#include "experiments/papers/capture/fig18.hpp"

#include "experiments/papers/capture/hall.hpp"
#include "fulbito/models.hpp"

namespace fulbito::capture {
namespace {

constexpr double kDegree = math::kPi / 180;
constexpr double kRoom = 0.05;  // [m] between the bodies' circles during the capture

}  // namespace

Pose2 fig18Robot() { return {{1.0, 2.0}, 90 * kDegree}; }

ObjectMotion fig18Object() { return {{2.0, 0.0}, math::unit(40 * kDegree) * 0.3, 0.0}; }

CaptureLimits fig18Limits() {
  CaptureLimits limits;
  limits.least_radius1 = 2.6;  // also the largest possible one
  limits.least_radius3 = limits.greatest_radius3 = 2.4;
  return limits;
}

double fig18Turn(double top_speed) {
  const CaptureLimits limits = fig18Limits();
  // v = a t r / (r + b/2) and turn = a t^2 / 2 (r + b/2).
  const double radius = limits.least_radius1, outer = radius + limits.track / 2;
  const double time = top_speed * outer / (limits.acceleration * radius);
  return limits.acceleration * time * time / (2 * outer);
}

std::optional<CapturePlan> fig18Plan(double turn) {
  const CaptureLimits limits = fig18Limits();
  return capturePlan(limits, {fig18Robot(), fig18Object(), 0.0}, -1.0, limits.least_radius1, turn,
                     limits.least_radius3);
}

std::optional<CapturePlan> printedPlan() { return fig18Plan(fig18Turn(0.546)); }

PursuitSetup fig18Setup(const RobotModel& robot, double gap, const SightingNoise& noise, std::uint64_t seed) {
  PursuitSetup setup;
  setup.robot = robot;
  setup.start = fig18Robot();
  setup.object = fig18Object();
  setup.limits = fig18Limits();
  setup.gap = gap;
  setup.noise = noise;
  setup.seed = seed;
  setup.index = 500'000;  // different from the indices of random captures
  return setup;
}

double halfLengths(const RobotModel& robot) { return (robot.length + objectModel().length) / 2; }

CaptureLimits limitsWithoutTouch(const RobotModel& robot) {
  CaptureLimits limits;
  limits.clearance = robot.circumradius() + objectModel().circumradius() + kRoom;
  return limits;
}

}  // namespace fulbito::capture
