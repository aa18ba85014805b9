#include "strategies/team_pilots.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "navigation/followers/limiter.hpp"
#include "navigation/guidance_strokes.hpp"
#include "strategies/interface/drawings.hpp"

namespace fulbito {
namespace {

constexpr double kSpeeds = 256.0;  // speed steps of a wheel in each direction

/// The step [rad/s] of wheel commands: a whole multiple of the step to which the physics rounds.
double commandStep(const MatchInfo& info) {
  const double step = info.robot.max_wheel_speed / kSpeeds;
  const double least = info.physics.wheel_command_step;
  return least > 0.0 ? std::max(1.0, std::floor(step / least + 1e-9)) * least : step;
}

/// The same robot with front and back exchanged.
RobotState turnedRound(RobotState robot) {
  robot.pose.heading = math::wrapAngle(robot.pose.heading + math::kPi);
  robot.wheels = {-robot.wheels.right, -robot.wheels.left};
  return robot;
}

/// Direction [rad] in which `pilot` wanted to leave `from` at its last plan, or toward `goal` without a plan.
double wantedDirection(const Pilot& pilot, bool planned, Vec2 from, Vec2 goal) {
  const Guidance& guidance = pilot.guidance();
  if (planned && guidance.kind == GuidanceKind::kField && guidance.field != nullptr) {
    return guidance.field->heading(from);
  }
  if (planned && guidance.path.size() > 1) {
    constexpr double kAhead = 0.03;  // [m]
    for (const Vec2 point : guidance.path) {
      if (distance(point, from) > kAhead) return math::angleOf(point - from);
    }
  }
  return math::angleOf(goal - from);
}

}  // namespace

Result<TeamPilots> TeamPilots::create(const MatchInfo& info, std::span<const NavigatorChoice> navigators) {
  TeamPilots team;
  team.info_ = info;
  team.step_ = commandStep(info);
  team.top_ = std::floor(info.robot.max_wheel_speed / team.step_ + 1e-9) * team.step_;
  team.slowed_ = info.robot;
  team.steady_ = steady(info.robot);
  team.foresight_ = Foresight(info);
  team.drivers_.resize(static_cast<std::size_t>(info.rules.team_size));
  for (Driver& driver : team.drivers_) {
    for (const NavigatorChoice& choice : navigators) {
      auto pilot = makePilot(choice);
      if (!pilot) return tl::unexpected<Error>(pilot.error());
      driver.pilots.push_back(std::move(*pilot));
    }
  }
  team.discs_.reserve(2 * kMaxTeamSize + 1);
  team.warmUp();
  return team;
}

// Each navigator drives once on a full field, so that its buffers have their size. Otherwise a navigator that
// the strategy asks for minutes later would allocate memory in a tick.
void TeamPilots::warmUp() {
  Observation full;
  full.dt = info_.physics.controlPeriod();
  full.team_size = info_.rules.team_size;
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    const double y =
        (static_cast<double>(i + 1) / static_cast<double>(drivers_.size() + 1) - 0.5) * info_.field.width;
    full.own[i].present = full.opponents[i].present = true;
    full.own[i].state.pose.position = {-info_.field.length / 4, y};
    full.opponents[i].state.pose.position = {info_.field.length / 8, y};
  }
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    GoTo go_to;
    go_to.position = {info_.field.length / 3, 0.0};
    go_to.heading = 0.0;
    go_to.avoid_ball = true;
    for (std::size_t n = 0; n < drivers_[i].pilots.size(); ++n) {
      go_to.navigator = static_cast<std::uint8_t>(n);
      goTo(full, static_cast<int>(i), go_to);
    }
  }
  reset();
}

void TeamPilots::reset() {
  for (Driver& driver : drivers_) {
    for (auto& pilot : driver.pilots) pilot->reset();
    driver.last = -1;
    driver.backward = false;
  }
}

std::array<WheelSpeeds, kMaxTeamSize> TeamPilots::drive(const Observation& observation,
                                                        const TeamCommand& command) {
  const Observation& now = foresight_.isNeeded() ? foresight_.update(observation) : observation;
  std::array<WheelSpeeds, kMaxTeamSize> wheels{};
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    if (now.own[i].present) wheels[i] = driveRobot(now, static_cast<int>(i), command.robots[i]);
  }
  return wheels;
}

void TeamPilots::draw(const Observation& observation, const TeamCommand& command,
                      std::vector<DebugDrawing>& drawings) const {
  constexpr double kPlace = 0.015;  // [m] radius of the mark of a place
  std::vector<GuidanceStroke> strokes;
  for (std::size_t i = 0; i < drivers_.size(); ++i) {
    const Driver& driver = drivers_[i];
    const RobotCommand& wanted = command.robots[i];
    const bool driven = wanted.kind == RobotCommand::Kind::kGoTo && driver.last == wanted.go_to.navigator;
    if (!observation.own[i].present || !driven) continue;
    const Pilot& pilot = *driver.pilots[wanted.go_to.navigator];
    addStrokes(pilot.guidance(), observation.own[i].state.pose.position, wanted.go_to.position, strokes);
    addCircle(drawings, wanted.go_to.position, kPlace);
  }
  for (const GuidanceStroke& stroke : strokes) addLine(drawings, stroke.from, stroke.to);
}

WheelSpeeds TeamPilots::driveRobot(const Observation& observation, int robot, const RobotCommand& wanted) {
  if (wanted.kind == RobotCommand::Kind::kGoTo) return inSteps(goTo(observation, robot, wanted.go_to));
  const auto i = static_cast<std::size_t>(robot);
  drivers_[i].last = -1;
  if (wanted.kind == RobotCommand::Kind::kWheels) return wanted.wheels;
  // The wheels' own sensors: velocities that a camera gives would make the wheels follow its noise.
  const Twist now = forwardKinematics(info_.robot, observation.own[i].state.wheels);
  const Twist limited = limitTwist(steady_, now, wanted.twist, observation.dt);
  return inSteps(inverseKinematics(info_.robot, limited));
}

// The rounding models a real robot's radio. It has no measurable effect on any team's results and makes
// recordings a fifth smaller.
WheelSpeeds TeamPilots::inSteps(WheelSpeeds wheels) const {
  const WheelSpeeds rounded = roundedTo(wheels, step_);
  return {std::clamp(rounded.left, -top_, top_), std::clamp(rounded.right, -top_, top_)};
}

void TeamPilots::chooseFront(Driver& driver, const RobotState& robot, const GoTo& go_to) const {
  // A fast robot turns round in less time than it stops. Near a right angle both ends are equally good.
  constexpr double kSlow = 0.3;                // [m/s]
  constexpr double kClearly = math::kPi / 12;  // [rad] beyond a right angle
  if (!go_to.either_front) {
    driver.backward = false;
    return;
  }
  if (norm(robot.velocity) > kSlow && driver.last >= 0) return;
  const bool planned = driver.last == go_to.navigator;
  const double wanted =
      wantedDirection(*driver.pilots[go_to.navigator], planned, robot.pose.position, go_to.position);
  const double heading = robot.pose.heading + (driver.backward ? math::kPi : 0.0);
  if (std::abs(math::wrapAngle(wanted - heading)) > math::kPi / 2 + kClearly)
    driver.backward = !driver.backward;
}

WheelSpeeds TeamPilots::goTo(const Observation& observation, int robot, const GoTo& go_to) {
  Driver& driver = drivers_[static_cast<std::size_t>(robot)];
  if (go_to.navigator >= driver.pilots.size()) return {};
  Pilot& pilot = *driver.pilots[go_to.navigator];
  const RobotState& self = observation.own[static_cast<std::size_t>(robot)].state;
  chooseFront(driver, self, go_to);
  if (driver.last != go_to.navigator) pilot.reset();
  driver.last = go_to.navigator;

  discs_.clear();
  const double radius = info_.robot.circumradius();
  const auto see = [&](const std::array<ObservedRobot, kMaxTeamSize>& robots, int except) {
    for (int i = 0; i < observation.team_size; ++i) {
      const ObservedRobot& seen = robots[static_cast<std::size_t>(i)];
      if (seen.present && i != except) {
        discs_.push_back({seen.state.pose.position, radius, seen.state.velocity});
      }
    }
  };
  if (go_to.avoid_mates) see(observation.own, robot);
  if (go_to.avoid_opponents) see(observation.opponents, -1);
  if (go_to.avoid_ball) {
    discs_.push_back({observation.ball.position, info_.ball.radius, observation.ball.velocity});
  }
  slowed_.max_wheel_speed =
      std::clamp(go_to.speed_limit / info_.robot.wheel_radius, 0.0, info_.robot.max_wheel_speed);
  NavigationScene scene;
  scene.tick = observation.tick;
  scene.dt = observation.dt;
  scene.self = driver.backward ? turnedRound(self) : self;
  scene.goal.position = go_to.position;
  scene.goal.heading = go_to.heading;
  scene.goal.tolerance = go_to.tolerance;
  scene.goal.stop = go_to.stop;
  scene.obstacles = discs_;
  scene.field = &info_.field;
  scene.robot = &slowed_;
  const WheelSpeeds wheels = pilot.drive(scene);
  return driver.backward ? WheelSpeeds{-wheels.right, -wheels.left} : wheels;
}

}  // namespace fulbito
