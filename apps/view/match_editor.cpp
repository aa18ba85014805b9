#include "apps/view/match_editor.hpp"

#include "fulbito/detail/math.hpp"
#include "match/play/edit.hpp"

namespace fulbito {
namespace {

constexpr double kReach = 0.015;  // [m] tolerance when grabbing a body

}  // namespace

std::optional<RobotId> MatchEditor::robotAt(Vec2 place) const {
  const RobotModel& model = match_->config().robot.robot;
  const double radius = norm({model.length / 2, model.width / 2});
  std::optional<RobotId> nearest;
  double least = radius;
  const WorldState& world = match_->world();
  for (std::size_t i = 0; i < match_->ids().size(); ++i) {
    const double away = distance(world.robots[i].pose.position, place);
    if (away > least) continue;
    least = away;
    nearest = match_->ids()[i];
  }
  return nearest;
}

Pose2& MatchEditor::poseOf(Placement& placement, RobotId id) const {
  return *placement.robots[indexOf(id.team)][id.number];
}

bool MatchEditor::grab(Vec2 place, bool turn) {
  release();
  if (match_->referee().ended) return false;
  placement_ = match_->placement();
  const bool ball = distance(placement_.ball, place) < match_->config().robot.ball.radius + kReach;
  if (ball && !turn) {
    held_ = Held{{}, false, placement_.ball - place, false};
    return true;
  }
  const auto robot = robotAt(place);
  if (!robot) return false;
  held_ = Held{robot, turn, poseOf(placement_, *robot).position - place, false};
  return true;
}

bool MatchEditor::tryOut(const Placement& wanted) {
  const auto flaw = flawOfEdit(match_->config(), match_->placement(), wanted);
  flaw_ = flaw.value_or("");
  if (flaw) return false;
  placement_ = wanted;
  return true;
}

void MatchEditor::drag(Vec2 place) {
  if (!held_) return;
  Placement wanted = placement_;
  if (!held_->robot) {
    wanted.ball = place + held_->offset;
    wanted.ball_velocity = {};
  } else if (held_->turn) {
    Pose2& pose = poseOf(wanted, *held_->robot);
    const Vec2 front = place - pose.position;
    if (squaredNorm(front) > 0.0) pose.heading = math::atan2(front.y, front.x);
  } else {
    poseOf(wanted, *held_->robot).position = place + held_->offset;
  }
  if (tryOut(wanted)) held_->changed = true;
}

bool MatchEditor::apply() {
  const auto replaced = match_->replace(placement_);
  if (!replaced) flaw_ = replaced.error().message;
  return replaced.has_value();
}

bool MatchEditor::drop() {
  const bool changed = held_ && held_->changed;
  release();
  return changed && apply();
}

bool MatchEditor::turn(Vec2 place, double angle) {
  if (match_->referee().ended || held_) return false;
  const auto robot = robotAt(place);
  if (!robot) return false;
  Placement wanted = match_->placement();
  Pose2& pose = poseOf(wanted, *robot);
  pose.heading = math::wrapAngle(pose.heading + angle);
  return tryOut(wanted) && apply();
}

}  // namespace fulbito
