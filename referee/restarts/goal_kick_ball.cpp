#include "referee/restarts/goal_kick_ball.hpp"

#include <algorithm>

#include "fulbito/detail/math.hpp"
#include "referee/geometry/areas.hpp"
#include "referee/restarts/restart_call.hpp"

namespace fulbito {
namespace {

constexpr double kGap = 1e-4;      // [m] between the ball and the goal line
constexpr double kNoticed = 1e-3;  // [m] shorter repairs are not reported

/// The point of the area nearest to `p` with the whole ball on the field, in the goal's frame.
Vec2 intoArea(const AreaShape& area, double radius, Vec2 p) {
  const double least = std::min(radius + kGap, area.depth);
  const Vec2 box{std::clamp(p.x, least, area.depth), std::clamp(p.y, -area.half_width, area.half_width)};
  const Vec2 centre{area.arc_centre, 0.0};
  const Vec2 arc =
      distance(p, centre) > area.arc_radius ? centre + unitOr(p - centre, {1.0, 0.0}) * area.arc_radius : p;
  return arc.x > area.depth && distance(arc, p) < distance(box, p) ? arc : box;
}

Vec2 allowedPlace(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call, Vec2 wish) {
  if (call.kind != RestartKind::kGoalKick || !setup.rules.goal_kick.ball_free || !isFinite(wish)) {
    return call.ball;
  }
  const Side side = state.sideOf(call.team);
  const AreaShape area = goalAreaOf(setup.field, setup.rules.areas.arc);
  const Vec2 there = intoArea(area, setup.ball.radius, intoGoalFrame(setup.field, side, wish));
  return outOfGoalFrame(setup.field, side, there);
}

GameEvent repairEvent(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call,
                      double moved) {
  GameEvent event;
  event.tick = state.last_tick;
  event.play_time = static_cast<double>(state.play_ticks) * setup.dt;
  event.period = static_cast<std::uint8_t>(state.period);
  event.clause = "placement";
  event.law = call.kind == RestartKind::kGoalKick ? "13" : "";
  event.team = call.team;
  event.place = call.ball;
  event.value = event.margin = moved;
  return event;
}

}  // namespace

RestartCall withBall(const RefereeSetup& setup, const RefereeState& state, const RestartCall& call, Vec2 wish,
                     std::vector<GameEvent>& log) {
  RestartCall moved = call;
  moved.ball = moved.defaults.ball = allowedPlace(setup, state, call, wish);
  std::optional<Pose2>& keeper = moved.defaults.robots[indexOf(call.team)][0];
  if (call.kind == RestartKind::kGoalKick && keeper) {
    keeper = goalKickKeeper(setup, ownSign(state, call.team), moved.ball);
  }
  const double off = isFinite(wish) ? distance(wish, moved.ball) : 0.0;
  if (!(off < kNoticed) || !isFinite(wish)) log.push_back(repairEvent(setup, state, moved, off));
  return moved;
}

}  // namespace fulbito
