#include "experiments/papers/capture/pursuit.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/papers/capture/hall.hpp"
#include "experiments/papers/random/streams.hpp"
#include "fulbito/models.hpp"
#include "fulbito/report.hpp"
#include "fulbito/world.hpp"

namespace fulbito::capture {
namespace {

// [s] before the start. A line through n places with errors s over T seconds has a speed error of s sqrt(12 /
// n) / T. With s = 2 cm and ten sightings per second, 6.5 s predict the place 30 s ahead to 4.5 cm, which is
// a fifth of the gap.
constexpr double kWatch = 6.5;
constexpr int kSightingTicks = 6;     // ten sightings per second
constexpr double kShiftSpeed = 0.02;  // [m/s] greatest speed with which the plan shifts with the estimate
constexpr double kShiftTime = 2.0;    // [s] time constant of the shift after small changes

/// Both bodies, in one world or each in its own.
class Arena {
 public:
  static Result<Arena> create(const PursuitSetup& setup) {
    const double speed = norm(setup.object.velocity);
    const RobotPlacement object =
        placed(objectModel(), {setup.object.at(0.0), math::angleOf(setup.object.velocity)}, speed);
    WorldConfig config;
    config.field = hall();
    config.physics = hallPhysics();
    config.robots = {placed(setup.robot, setup.start, 0.0)};
    if (setup.together) config.robots.push_back(object);
    auto first = World::create(config);
    if (!first) return tl::unexpected<Error>(first.error());
    std::vector<World> worlds;
    worlds.push_back(std::move(*first));
    if (!setup.together) {
      config.robots = {object};
      auto second = World::create(config);
      if (!second) return tl::unexpected<Error>(second.error());
      worlds.push_back(std::move(*second));
    }
    return Arena(std::move(worlds), speed / objectModel().wheel_radius);
  }

  void step(WheelSpeeds robot) {
    const std::array<WheelSpeeds, 2> commands{robot, {object_wheels_, object_wheels_}};
    if (worlds_.size() == 1) {
      worlds_[0].step(commands);
    } else {
      worlds_[0].step({commands.data(), 1});
      worlds_[1].step({commands.data() + 1, 1});
    }
    touched_ = touched_ || !worlds_[0].contacts().empty();
  }
  const RobotState& robot() const { return worlds_[0].state().robots[0]; }
  const RobotState& object() const { return worlds_.back().state().robots.back(); }
  bool touched() const { return touched_; }

 private:
  Arena(std::vector<World> worlds, double object_wheels)
      : worlds_(std::move(worlds)), object_wheels_(object_wheels) {}

  std::vector<World> worlds_;
  double object_wheels_;
  bool touched_ = false;
};

/// The camera's sightings and the estimate from them.
class Watcher {
 public:
  explicit Watcher(const PursuitSetup& setup)
      : noise_(setup.noise), rng_(setup.seed, kSightingStream, setup.index) {}

  void look(double time, Vec2 from, Vec2 object) {
    const Vec2 to = object - from;
    sightings_.push_back({time, from, math::angleOf(to) + rng_.normal(0.0, noise_.bearing),
                          norm(to) + rng_.normal(0.0, noise_.range)});
    if (sightings_.size() > 1) estimate_ = fitMotion(sightings_, noise_);
  }
  const ObjectMotion& estimate() const { return estimate_; }

 private:
  SightingNoise noise_;
  Rng rng_;
  std::vector<Sighting> sightings_;
  ObjectMotion estimate_;
};

/// The current plan and its shift.
class Guide {
 public:
  Guide(const CaptureLimits& limits, const CapturePlan& plan, double gap)
      : limits_(limits), plan_(plan), gap_(gap) {}

  /// Uses a newer estimate for the plan.
  void update(double time, const ObjectMotion& object) {
    if (!replanned_ && time >= plan_.straight_from) replan(object);
    if (!replanned_) return;
    const Vec2 line = unitOr(object.velocity, {1.0, 0.0});
    wanted_ = object.at(plan_.motion.duration()) - line * gap_ - plan_.motion.end().pose.position;
  }

  /// Shifts the plan by one tick.
  void advance(double dt) {
    const Vec2 lack = wanted_ - shift_;
    const double speed = norm(lack) / kShiftTime;
    shift_ += lack * (dt / kShiftTime * std::min(1.0, kShiftSpeed / std::max(speed, 1e-12)));
  }

  MotionState reference(double time) const {
    MotionState state = plan_.motion.at(time);
    state.pose.position += shift_;
    return state;
  }
  const CapturePlan& plan() const { return plan_; }

 private:
  void replan(const ObjectMotion& object) {
    replanned_ = true;
    // The robot has driven the first part, and the rest of the plan begins at its end.
    MotionProfile start(plan_.motion.at(0.0).pose);
    const double yaw = plan_.top_speed / plan_.radius1 * plan_.side;
    start.append({plan_.time1, {}, {plan_.top_speed, yaw}});
    start.append({plan_.straight_from - plan_.time1, {plan_.top_speed, yaw}, {plan_.top_speed, 0.0}});
    auto better = replanEnd(limits_, start, plan_.top_speed, object, plan_.radius3, gap_);
    if (!better) return;
    better->side = plan_.side, better->radius1 = plan_.radius1, better->turn1 = plan_.turn1;
    better->time1 = plan_.time1;
    plan_ = *better;
  }

  CaptureLimits limits_;
  CapturePlan plan_;
  double gap_;
  bool replanned_ = false;
  Vec2 wanted_, shift_;
};

WheelSpeeds commandOf(const PursuitSetup& setup, const MotionState& reference, const Pose2& robot) {
  if (setup.drive == PursuitDrive::kOpen) return inverseKinematics(setup.robot, reference.twist);
  return wheelsOverGround(setup.robot, trackingTwist(reference, robot));
}

void measureEnd(const PursuitSetup& setup, const Arena& arena, PursuitResult& result) {
  const Vec2 line = math::unit(math::angleOf(setup.object.velocity));
  const RobotState& robot = arena.robot();
  const Vec2 ahead = arena.object().pose.position - robot.pose.position;
  result.gap = dot(ahead, line);
  result.aside = -cross(line, ahead);
  result.speed = dot(robot.velocity, math::unit(robot.pose.heading));
  result.heading = robot.pose.heading;
  result.touched = arena.touched();
}

double fastestRim(const RobotModel& robot, WheelSpeeds wheels) {
  return std::max(std::abs(wheels.left), std::abs(wheels.right)) * robot.wheel_radius;
}

void drive(const PursuitSetup& setup, Arena& arena, Watcher& watcher, PursuitResult& result) {
  const double dt = hallPhysics().controlPeriod();
  const bool tracked = setup.drive == PursuitDrive::kTracked;
  Guide guide(setup.limits, *result.answer.plan, setup.gap);
  for (int tick = 0;; ++tick) {
    const double time = tick * dt;
    result.robot.push_back(arena.robot().pose);
    result.object.push_back(arena.object().pose);
    if (tracked && tick % kSightingTicks == 0) {
      watcher.look(time, arena.robot().pose.position, arena.object().pose.position);
      result.estimates.push_back(watcher.estimate());
      guide.update(time, watcher.estimate());
    }
    const double off = distance(guide.reference(time).pose.position, arena.robot().pose.position);
    result.worst_off = std::max(result.worst_off, off);
    if (time >= guide.plan().motion.duration()) {
      result.time = time;
      break;
    }
    guide.advance(dt);
    // The command leads to the reference at the end of the tick.
    const WheelSpeeds wheels = commandOf(setup, guide.reference(time + dt), arena.robot().pose);
    result.largest_rim = std::max(result.largest_rim, fastestRim(setup.robot, wheels));
    arena.step(wheels);
  }
  result.driven = guide.plan();
  measureEnd(setup, arena, result);
}

}  // namespace

Result<PursuitResult> pursue(const PursuitSetup& setup) {
  auto arena = Arena::create(setup);
  if (!arena) return tl::unexpected<Error>(arena.error());
  Watcher watcher(setup);
  const double every = kSightingTicks * hallPhysics().controlPeriod();
  const int looks = static_cast<int>(std::lround(kWatch / every));
  for (int i = -looks; i < 0; ++i) watcher.look(i * every, setup.start.position, setup.object.at(i * every));
  PursuitResult result;
  result.answer = planCapture(setup.limits, {setup.start, watcher.estimate(), setup.gap});
  if (result.answer.plan) drive(setup, *arena, watcher, result);
  return result;
}

}  // namespace fulbito::capture
