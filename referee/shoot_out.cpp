#include "referee/shoot_out.hpp"

#include <cmath>

#include "referee/restart_call.hpp"
#include "referee/ticks.hpp"

namespace fulbito {
namespace {

constexpr double kMoved = 0.005;  // [m] off its mark the ball has been kicked

/// Kicks that the team may still take while the other cannot lengthen the lead for free.
int kicksLeft(const ShootOutRules& rules, const ShootOutState& s, TeamId team) {
  const int taken = s.taken[indexOf(team)];
  if (taken < rules.kicks) return rules.kicks - taken;
  return taken < s.taken[indexOf(other(team))] ? 1 : 0;
}

bool inGoalArea(const FieldGeometry& field, double toward_goal, Vec2 p) {
  return toward_goal * p.x >= field.length / 2 - field.goal_area_depth &&
         std::abs(p.y) <= field.goal_area_width / 2;
}

bool atRest(const RefereeSetup& setup, const RefereeState& state, const BallState& ball, ShootOutState& s) {
  const ShootOutRules& rules = setup.rules.shoot_out;
  const bool rests =
      norm(ball.velocity) <= rules.rest_speed && distance(ball.position, state.last.ball) > kMoved;
  s.still_ticks = rests ? s.still_ticks + 1 : 0;
  return rules.ends_at_rest && rests && s.still_ticks >= ticksOf(rules.rest_seconds, setup.dt);
}

}  // namespace

TeamId nextKicker(const ShootOutRules& rules, const ShootOutState& s) {
  const int first = s.taken[indexOf(s.first)], second = s.taken[indexOf(other(s.first))];
  if (rules.order == ShootOutOrder::kSeries && first < rules.kicks) return s.first;
  return first > second ? other(s.first) : s.first;
}

std::optional<TeamId> leader(const ShootOutRules& rules, const ShootOutState& s) {
  for (const TeamId team : kTeams) {
    const TeamId rival = other(team);
    if (s.goals[indexOf(team)] > s.goals[indexOf(rival)] + kicksLeft(rules, s, rival)) return team;
  }
  return std::nullopt;
}

bool exhausted(const ShootOutRules& rules, const ShootOutState& s) {
  return s.taken[0] >= rules.max_kicks && s.taken[1] >= rules.max_kicks;
}

std::optional<KickEnd> observeKick(const RefereeSetup& setup, const RefereeState& state,
                                   const BallState& ball, ShootOutState& s) {
  const ShootOutRules& rules = setup.rules.shoot_out;
  const double toward_goal = -ownSign(state, state.last.team);
  const double x = toward_goal * ball.position.x;
  const double beyond = setup.rules.goal.ball == BallPart::kWhole ? setup.ball.radius : 0.0;
  if (x > setup.field.length / 2 + beyond) return KickEnd::kGoal;
  const bool in_area = inGoalArea(setup.field, toward_goal, ball.position);
  if (in_area) s.entered_area = true;
  if (rules.ends_leaving_area && s.entered_area && !in_area) return KickEnd::kLeftArea;
  if (rules.ends_past_midfield && x < 0.0) return KickEnd::kMidfield;
  if (atRest(setup, state, ball, s)) return KickEnd::kRest;
  if (state.play_ticks >= ticksOf(rules.kick_seconds, setup.dt)) return KickEnd::kTime;
  return std::nullopt;
}

}  // namespace fulbito
