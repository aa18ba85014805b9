#include "apps/simulator/simulated_field.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "referee/match/match_referee.hpp"
#include "referee/restarts/restart_placement.hpp"

namespace fulbito::simulator {
namespace {

constexpr double kFastestBall = 49.0;  // [m/s] the world takes up to 50
constexpr double kInside = 1e-6;       // [m] to the walls, of what the engine has pressed into them

/// The nearest place that a world takes.
Vec2 within(const FieldGeometry& field, Vec2 position) {
  return insideField(field, position) ? position : insideWalls(field, position, kInside);
}

}  // namespace

Placement startOf(const MatchConfig& config) {
  if (config.start) return *config.start;
  MatchReferee referee(refereeSetup(config));
  const RestartCall call = referee.open();
  std::vector<GameEvent> repairs;
  return place(referee.setup(), referee.state(), call, {}, repairs);
}

SimulatedField::SimulatedField(const MatchConfig& config) : config_(config) {
  for (auto& team : robots_) team.resize(static_cast<std::size_t>(config.rules.team_size));
}

Result<SimulatedField> SimulatedField::create(const MatchConfig& config, const Placement& start) {
  SimulatedField field(config);
  for (const TeamId team : kTeams) {
    for (std::size_t i = 0; i < field.robots_[indexOf(team)].size(); ++i) {
      const auto& pose = start.robots[indexOf(team)][i];
      if (!pose) continue;
      Robot& robot = field.robots_[indexOf(team)][i];
      robot.state.pose = *pose;
      robot.on = robot.was_on = robot.inside = true;
    }
  }
  field.ball_ = {start.ball, start.ball_velocity, start.ball_velocity};
  field.ball_inside_ = true;
  if (auto built = field.build(); !built) return tl::unexpected<Error>(built.error());
  return field;
}

/// A world cannot move a body, so all are built anew, in motion as they were. Wheels that slip start anew.
Result<void> SimulatedField::build() {
  WorldConfig setup;
  setup.field = config_.field;
  setup.physics = config_.physics;
  for (const auto& team : robots_) {
    for (const Robot& robot : team) {
      if (!robot.inside) continue;
      const Pose2 pose{within(config_.field, robot.state.pose.position), robot.state.pose.heading};
      setup.robots.push_back({config_.robot.robot, pose, robot.state.velocity, robot.state.angular_velocity});
    }
  }
  if (ball_inside_) {
    setup.balls.push_back(
        {config_.robot.ball, within(config_.field, ball_.position), ball_.velocity, ball_.spin});
  }
  auto world = World::create(setup);
  if (!world) return tl::unexpected<Error>(world.error());
  world_ = std::move(*world);
  moved_ = false;
  return {};
}

bool SimulatedField::put(const wire::RobotReplacement& wish, wire::OddityLog& oddities) {
  const auto name = [&] { return fmt::format("replacement of {} robot {}", nameOf(wish.team), wish.number); };
  auto& team = robots_[indexOf(wish.team)];
  if (wish.number >= team.size()) {
    oddities.note(wire::Oddity::kUnknown, name());
    return false;
  }
  if (!isFinite(wish.pose.position) || !std::isfinite(wish.pose.heading)) {
    oddities.note(wire::Oddity::kNotFinite, name());
    return false;
  }
  Robot& robot = team[wish.number];
  robot.state.pose = {wish.pose.position, math::wrapAngle(wish.pose.heading)};
  robot.inside = insideField(config_.field, wish.pose.position);
  if (!robot.inside) {
    robot.state.velocity = {};
    robot.state.angular_velocity = 0.0;
  }
  robot.on = wish.on;
  return true;
}

void SimulatedField::put(const wire::BallReplacement& wish) {
  ball_ = {wish.position, wish.velocity, {}};
  ball_inside_ = insideField(config_.field, wish.position);
  const double speed = norm(wish.velocity);
  if (!ball_inside_) {
    ball_.velocity = {};
  } else if (speed > kFastestBall) {
    ball_.velocity = wish.velocity * (kFastestBall / speed);
  }
}

int SimulatedField::replace(const wire::Packet& packet, wire::OddityLog& oddities) {
  int obeyed = 0;
  for (const wire::RobotReplacement& wish : packet.robots) obeyed += put(wish, oddities) ? 1 : 0;
  if (packet.ball) {
    if (isFinite(packet.ball->position) && isFinite(packet.ball->velocity)) {
      put(*packet.ball);
      ++obeyed;
    } else {
      oddities.note(wire::Oddity::kNotFinite, "replacement of the ball");
    }
  }
  moved_ = moved_ || obeyed > 0;
  return obeyed;
}

Result<void> SimulatedField::step(const Wheels& wheels) {
  if (moved_) {
    if (auto built = build(); !built) return built;
  }
  commands_.clear();
  for (const TeamId team : kTeams) {
    auto& robots = robots_[indexOf(team)];
    for (std::size_t i = 0; i < robots.size(); ++i) {
      robots[i].was_on = robots[i].on;
      if (!robots[i].inside) continue;
      commands_.push_back(robots[i].on ? wheels[indexOf(team)][i] : WheelSpeeds{});
    }
  }
  world_->step(commands_);
  read();
  return {};
}

void SimulatedField::read() {
  const WorldState& state = world_->state();
  std::size_t next = 0;
  for (auto& team : robots_) {
    for (Robot& robot : team) {
      if (robot.inside) robot.state = state.robots[next++];
    }
  }
  if (ball_inside_) ball_ = state.balls.front();
}

wire::Vision SimulatedField::vision() const {
  wire::Vision vision;
  vision.field = config_.field;
  vision.ball = ball_;
  vision.ball_height = config_.robot.ball.radius;
  for (const TeamId team : kTeams) {
    const auto& robots = robots_[indexOf(team)];
    for (std::size_t i = 0; i < robots.size(); ++i) {
      if (!robots[i].on) continue;
      vision.robots[indexOf(team)].push_back({static_cast<std::uint32_t>(i), robots[i].state});
    }
  }
  return vision;
}

std::uint32_t SimulatedField::on(TeamId team) const {
  std::uint32_t bits = 0;
  const auto& robots = robots_[indexOf(team)];
  for (std::size_t i = 0; i < robots.size(); ++i) bits |= (robots[i].on ? 1U : 0U) << i;
  return bits;
}

std::uint32_t SimulatedField::wentOff(TeamId team) const {
  std::uint32_t bits = 0;
  const auto& robots = robots_[indexOf(team)];
  for (std::size_t i = 0; i < robots.size(); ++i) {
    bits |= (robots[i].was_on && !robots[i].on ? 1U : 0U) << i;
  }
  return bits;
}

}  // namespace fulbito::simulator
