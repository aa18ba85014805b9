#include "match/play/edit.hpp"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "fulbito/detail/math.hpp"
#include "referee/geometry/placed_body.hpp"

namespace fulbito {
namespace {

constexpr double kGap = 1e-4;        // [m] between bodies, as at the restarts of the rules
constexpr double kFarthest = 100.0;  // [m] largest distance from the centre
constexpr double kMaxSpeed = 50.0;   // [m/s] as in a start state

struct Standing {
  RobotId id;
  Pose2 pose;
  bool moved = false;
};

bool same(const Pose2& a, const Pose2& b) { return a.position == b.position && a.heading == b.heading; }

bool near(Vec2 point) { return isFinite(point) && squaredNorm(point) < kFarthest * kFarthest; }

PlacedBody bodyOf(const RobotModel& robot, const Pose2& pose) {
  return {pose.position, math::unit(pose.heading), robot.length / 2, robot.width / 2};
}

/// Judges one placement.
class Editor {
 public:
  Editor(const MatchConfig& config, const Placement& before, const Placement& after)
      : config_(config), after_(after), ball_moved_(before.ball != after.ball) {
    for (const TeamId team : kTeams) {
      for (std::size_t i = 0; i < kMaxTeamSize; ++i) {
        const auto& old = before.robots[indexOf(team)][i];
        const auto& now = after.robots[indexOf(team)][i];
        if (old.has_value() != now.has_value()) same_robots_ = false;
        if (!old || !now) continue;
        robots_.push_back({{team, static_cast<std::uint8_t>(i)}, *now, !same(*old, *now)});
      }
    }
  }

  std::optional<std::string> flaw() const {
    if (!same_robots_) return "no robot may be added or removed";
    if (const char* wrong = ballFlaw()) return fmt::format("the ball {}", wrong);
    for (const Standing& robot : robots_) {
      if (const char* wrong = robotFlaw(robot)) {
        return fmt::format("{} robot {} {}", nameOf(robot.id.team), robot.id.number, wrong);
      }
    }
    return std::nullopt;
  }

 private:
  const char* ballFlaw() const {
    const double radius = config_.robot.ball.radius;
    const Vec2 speed = after_.ball_velocity;
    if (!isFinite(speed) || squaredNorm(speed) > kMaxSpeed * kMaxSpeed) return "would be too fast";
    if (!ball_moved_) return nullptr;
    const FieldGeometry& field = config_.field;
    const PlacedBody box{after_.ball, {1.0, 0.0}, radius, radius};
    if (!near(after_.ball) || std::abs(after_.ball.x) > field.length / 2 - radius || !onField(field, box)) {
      return "would not be on the field";
    }
    return nullptr;
  }

  const char* robotFlaw(const Standing& robot) const {
    if (robot.moved && (!near(robot.pose.position) || !std::isfinite(robot.pose.heading))) {
      return "would not be on the field";
    }
    const RobotModel& model = config_.robot.robot;
    const PlacedBody body = bodyOf(model, robot.pose);
    if (robot.moved && !onField(config_.field, body)) return "would not be on the field";
    if ((robot.moved || ball_moved_) && distanceTo(body, after_.ball) < config_.robot.ball.radius + kGap) {
      return "would overlap the ball";
    }
    for (const Standing& other : robots_) {
      if (!robot.moved || other.id == robot.id) continue;
      if (!apart(body, bodyOf(model, other.pose), kGap)) return "would overlap a robot";
    }
    return nullptr;
  }

  const MatchConfig& config_;
  const Placement& after_;
  const bool ball_moved_;
  bool same_robots_ = true;
  std::vector<Standing> robots_;
};

}  // namespace

Placement placementOf(const WorldState& world, std::span<const RobotId> ids) {
  Placement placement;
  placement.ball = world.balls.front().position;
  placement.ball_velocity = world.balls.front().velocity;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    placement.robots[indexOf(ids[i].team)][ids[i].number] = world.robots[i].pose;
  }
  return placement;
}

std::optional<std::string> flawOfEdit(const MatchConfig& config, const Placement& before,
                                      const Placement& after) {
  return Editor(config, before, after).flaw();
}

RestartCall editCall(const RefereeState& referee, const Placement& placement) {
  RestartCall call;
  call.kind = RestartKind::kGiven;
  call.team = referee.last.team;
  call.ball = placement.ball;
  call.defaults = placement;
  return call;
}

}  // namespace fulbito
