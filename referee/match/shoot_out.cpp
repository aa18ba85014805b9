#include "referee/match/shoot_out.hpp"

#include "referee/calls/detector_support.hpp"
#include "referee/geometry/areas.hpp"
#include "referee/geometry/ball_gap.hpp"
#include "referee/restarts/restart_call.hpp"
#include "referee/state/ticks.hpp"

namespace fulbito {
namespace {

constexpr double kMoved = 0.005;  // [m] a ball this far off its mark has been kicked

/// Regular kicks left for the team; in sudden death, the kicks that complete the pair.
int kicksLeft(const ShootOutRules& rules, const ShootOutState& s, TeamId team) {
  const int taken = s.taken[indexOf(team)];
  if (taken < rules.kicks) return rules.kicks - taken;
  return taken < s.taken[indexOf(other(team))] ? 1 : 0;
}

/// The goal area of the kick's keeper.
struct KeeperArea {
  AreaShape shape;
  Side side = Side::kLeft;

  bool has(const FieldGeometry& field, Vec2 p) const {
    return contains(shape, intoGoalFrame(field, side, p));
  }
  bool has(const RefereeSetup& setup, const Pose2& robot) const {
    const AreaBody body = intoGoalFrame(setup.field, side, setup.robot, robot);
    return counts(shape, body, setup.rules.areas.defenders_part);
  }
};

/// Whether the keeper has undisputed control of the ball in its area, as in law 8.1.
bool keeperHolds(const RefereeSetup& setup, const RefereeState& state, const MatchView& view,
                 const KeeperArea& area) {
  const KeeperRules& rules = setup.rules.keeper;
  const TeamId kicker = state.last.team;
  if (!area.has(setup.field, view.ball.position)) return false;
  if (disputes(view, setup.robot, kicker, rules.dispute_lengths)) return false;
  for (std::size_t i = 0; i < robotsIn(view); ++i) {
    const Pose2& pose = view.robots[i].pose;
    if (view.ids[i].team == kicker || !area.has(setup, pose)) continue;
    if (ballGap(setup.robot, pose, setup.ball, view.ball.position, rules.control_gap)) return true;
  }
  return false;
}

bool heldForLong(const RefereeSetup& setup, const RefereeState& state, const MatchView& view,
                 const KeeperArea& area, ShootOutState& s) {
  const double seconds = setup.rules.shoot_out.held_seconds;
  if (seconds <= 0.0) return false;
  s.held_ticks = keeperHolds(setup, state, view, area) ? s.held_ticks + 1 : 0;
  return s.held_ticks > 0 && s.held_ticks >= ticksOf(seconds, setup.dt);
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
                                   const MatchView& view, ShootOutState& s) {
  const ShootOutRules& rules = setup.rules.shoot_out;
  const BallState& ball = view.ball;
  const double toward_goal = -ownSign(state, state.last.team);
  const double x = toward_goal * ball.position.x;
  const double beyond = setup.rules.goal.ball == BallPart::kWhole ? setup.ball.radius : 0.0;
  if (x > setup.field.length / 2 + beyond) return KickEnd::kGoal;
  const KeeperArea area{goalAreaOf(setup.field, setup.rules.areas.arc), state.sideOf(other(state.last.team))};
  if (heldForLong(setup, state, view, area, s)) return KickEnd::kHeld;
  const bool in_area = area.has(setup.field, ball.position);
  if (in_area) s.entered_area = true;
  if (rules.ends_leaving_area && s.entered_area && !in_area) return KickEnd::kLeftArea;
  if (rules.ends_past_midfield && x < 0.0) return KickEnd::kMidfield;
  if (atRest(setup, state, ball, s)) return KickEnd::kRest;
  if (state.play_ticks >= ticksOf(rules.kick_seconds, setup.dt)) return KickEnd::kTime;
  return std::nullopt;
}

}  // namespace fulbito
