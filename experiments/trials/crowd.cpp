#include "experiments/trials/crowd.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/interval.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/world.hpp"

namespace fulbito {
namespace {

constexpr std::size_t kRobots = 6;
constexpr double kPatience = 6.0;     // [s] time after which a robot gets another goal
constexpr double kWallMargin = 0.12;  // [m] between goals and walls

/// One robot and its present goal.
struct Errand {
  std::unique_ptr<Pilot> pilot;
  Vec2 goal;
  Tick since = 0;
};

Vec2 randomPlace(Rng& rng, const FieldGeometry& field) {
  for (;;) {
    const Vec2 p{rng.uniform(-0.5, 0.5) * field.length, rng.uniform(-0.5, 0.5) * field.width};
    if (wallClearance(field, p) >= kWallMargin) return p;
  }
}

WorldConfig kickOff(const RobotPreset& robot, const FieldGeometry& field, const PhysicsProfile& physics) {
  WorldConfig config;
  config.field = field;
  config.physics = physics;
  for (std::size_t i = 0; i < kRobots; ++i) {
    const double side = i % 2 == 0 ? -1.0 : 1.0;
    const std::size_t row = i / 2;
    config.robots.push_back(
        {robot.robot, {{side * 0.3, 0.3 * (static_cast<double>(row) - 1.0)}, 0.0}, {}, 0.0});
  }
  config.balls.push_back({robot.ball, {}, {}, {}});
  return config;
}

void seeOthers(const WorldState& world, std::size_t self, double radius, std::vector<DiscObstacle>& discs) {
  discs.clear();
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    if (i != self) discs.push_back({world.robots[i].pose.position, radius, world.robots[i].velocity});
  }
}

/// All robots with their goals, simulated tick by tick.
class Crowd {
 public:
  Crowd(const RobotPreset& robot, const FieldGeometry& field, const PhysicsProfile& physics,
        std::uint64_t seed, const Clock& clock)
      : robot_(robot.robot),
        field_(field),
        clock_(clock),
        patience_(static_cast<Tick>(kPatience * physics.control_rate)),
        rng_(seed, Stream::kLayout, std::uint64_t{9} << 32) {
    scene_.dt = physics.controlPeriod();
    scene_.field = &field_;
    scene_.robot = &robot_;
  }

  void add(std::unique_ptr<Pilot> pilot) {
    errands_.push_back({std::move(pilot), randomPlace(rng_, field_), 0});
  }

  /// Commands of all robots for the world's next tick.
  std::span<const WheelSpeeds> drive(const WorldState& world) {
    commands_.resize(errands_.size());
    for (std::size_t i = 0; i < errands_.size(); ++i) {
      scene_.self = world.robots[i];
      scene_.tick = world.tick;
      renew(errands_[i]);
      scene_.goal.position = errands_[i].goal;
      seeOthers(world, i, robot_.circumradius(), discs_);
      scene_.obstacles = discs_;
      const std::int64_t begin = clock_ ? clock_() : 0;
      commands_[i] = errands_[i].pilot->drive(scene_);
      if (clock_) compute_us_.push_back(static_cast<double>(clock_() - begin) * 1e-3);
    }
    return commands_;
  }

  int arrivals() const { return arrivals_; }
  std::vector<double>& computeMicroseconds() { return compute_us_; }

 private:
  /// Sets another goal for a robot that has arrived or has tried for too long.
  void renew(Errand& errand) {
    const bool arrived = distance(scene_.self.pose.position, errand.goal) < scene_.goal.tolerance;
    if (!arrived && scene_.tick - errand.since <= patience_) return;
    arrivals_ += arrived ? 1 : 0;
    errand.goal = randomPlace(rng_, field_);
    errand.since = scene_.tick;
  }

  const RobotModel& robot_;
  const FieldGeometry& field_;
  const Clock& clock_;
  const Tick patience_;
  Rng rng_;
  NavigationScene scene_;
  std::vector<Errand> errands_;
  std::vector<DiscObstacle> discs_;
  std::vector<WheelSpeeds> commands_;
  std::vector<double> compute_us_;
  int arrivals_ = 0;
};

}  // namespace

Result<CrowdResult> runCrowd(const CrowdConfig& config, const Clock& clock) {
  const auto choice = parseNavigator(config.navigator);
  if (!choice) return tl::unexpected<Error>(choice.error());
  const auto robot = loadRobot(config.robot);
  if (!robot) return tl::unexpected<Error>(robot.error());
  const auto field = loadField("vsss-3v3");
  if (!field) return tl::unexpected<Error>(field.error());
  const auto physics = loadPhysics("standard");
  if (!physics) return tl::unexpected<Error>(physics.error());
  auto world = World::create(kickOff(*robot, *field, *physics));
  if (!world) return tl::unexpected<Error>(world.error());
  Crowd crowd(*robot, *field, *physics, config.seed, clock);
  for (std::size_t i = 0; i < kRobots; ++i) {
    auto pilot = makePilot(*choice);
    if (!pilot) return tl::unexpected<Error>(pilot.error());
    crowd.add(std::move(*pilot));
  }

  CrowdResult result;
  const Tick ticks = static_cast<Tick>(config.seconds * physics->control_rate);
  for (Tick tick = 0; tick < ticks; ++tick) {
    world->step(crowd.drive(world->state()));
    for (const ContactEvent& event : world->contacts()) {
      result.contacts += event.began && event.b.kind == BodyKind::kRobot ? 1 : 0;
    }
  }
  result.arrivals = crowd.arrivals();
  std::vector<double>& compute = crowd.computeMicroseconds();
  if (!compute.empty()) {
    result.compute_us_mean = mean(compute);
    result.compute_us_p99 = quantile(compute, 0.99);
    result.compute_us_max = quantile(compute, 1.0);
  }
  return result;
}

}  // namespace fulbito
