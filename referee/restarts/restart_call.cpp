#include "referee/restarts/restart_call.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "referee/state/ticks.hpp"

namespace fulbito {
namespace {

const PlaceTable& placesOf(const Rules& rules, RestartKind kind) {
  switch (kind) {
    case RestartKind::kFreeBall:
      return rules.free_ball.places;
    case RestartKind::kFreeKick:
      return rules.free_kick.places;
    case RestartKind::kPenalty:
      return rules.penalty.places;
    case RestartKind::kGoalKick:
      return rules.goal_kick.places;
    case RestartKind::kKickOff:
    case RestartKind::kGiven:
      break;
  }
  return rules.kick_off.places;
}

/// The sign of y of the team's keeper (robot 0 while none is known): +1 or -1.
double keeperSide(const Stoppage& stoppage) {
  if (stoppage.view == nullptr) return 1.0;
  const MatchView& view = *stoppage.view;
  std::size_t keeper = stoppage.keeper.value_or(view.ids.size());
  for (std::size_t i = 0; i < view.ids.size() && keeper >= view.ids.size(); ++i) {
    if (view.ids[i] == RobotId{stoppage.team, 0}) keeper = i;
  }
  return keeper < view.ids.size() && view.robots[keeper].pose.position.y < 0.0 ? -1.0 : 1.0;
}

/// The sign of y whose spot is farther from the nearest opponent; if equal, the keeper's.
double openSide(const RefereeSetup& setup, const Stoppage& stoppage, double own) {
  const double keeper = keeperSide(stoppage);
  if (stoppage.view == nullptr || setup.rules.goal_kick.side == GoalKickSide::kKeeper) return keeper;
  const Vec2 spot = setup.rules.goal_kick.ball;
  double here = 1e9, there = 1e9;  // squared, on the keeper's side and on the other
  for (std::size_t i = 0; i < stoppage.view->ids.size(); ++i) {
    if (stoppage.view->ids[i].team == stoppage.team) continue;
    const Vec2 p = stoppage.view->robots[i].pose.position;
    here = std::min(here, squaredNorm(p - Vec2{own * spot.x, keeper * spot.y}));
    there = std::min(there, squaredNorm(p - Vec2{own * spot.x, -keeper * spot.y}));
  }
  return there > here ? -keeper : keeper;
}

/// Free balls are on the mark of the ball's quarter; from the field's long axis, on the attackers' left.
Vec2 quarterMark(const FieldGeometry& field, Vec2 ball) {
  const double x = ball.x > 0.0 ? 1.0 : -1.0;
  const double y = ball.y > 0.0 ? 1.0 : ball.y < 0.0 ? -1.0 : x;
  return {x * field.free_ball_mark.x, y * field.free_ball_mark.y};
}

Vec2 ballSpot(const RefereeSetup& setup, const RefereeState& state, const Stoppage& stoppage) {
  const double own = ownSign(state, stoppage.team);
  switch (stoppage.kind) {
    case RestartKind::kFreeBall:
      return quarterMark(setup.field, stoppage.ball);
    case RestartKind::kFreeKick:
      return {-own * setup.rules.free_kick.mark, 0.0};
    case RestartKind::kPenalty:
      return {-own * setup.field.penalty_mark, 0.0};
    case RestartKind::kGoalKick:
      return {own * setup.rules.goal_kick.ball.x,
              openSide(setup, stoppage, own) * setup.rules.goal_kick.ball.y};
    case RestartKind::kKickOff:
      return {};
    case RestartKind::kGiven:
      break;
  }
  return stoppage.ball;
}

double headingFor(double own_sign) { return own_sign < 0.0 ? 0.0 : -math::kPi; }

/// Places by table: x mirrored for the team at -x; some tables follow the ball.
Pose2 tablePose(const RefereeSetup& setup, const RestartCall& call, const PlaceTable& places, double own,
                bool takes, int number) {
  if (call.kind == RestartKind::kGoalKick && takes && number == 0) {
    return goalKickKeeper(setup, own, call.ball);
  }
  const std::vector<Vec2>& list = takes ? places.taker : places.other;
  const auto i = static_cast<std::size_t>(number);
  // More robots than places: one behind the other near the own goal; the placement spreads them.
  const Vec2 listed = i < list.size() ? list[i] : Vec2{list.empty() ? 0.5 : list.front().x, 0.0};
  Vec2 place{own * listed.x, listed.y};
  Pose2 pose{place, headingFor(own)};
  if (call.kind == RestartKind::kFreeBall && call.ball.y < 0.0) pose.position.y = -pose.position.y;
  return pose;
}

/// The place next to the ball that law 14 gives to one robot per team.
Vec2 robotMark(const RefereeSetup& setup, Vec2 ball, double own_sign) {
  return {ball.x + own_sign * setup.rules.free_ball.distance, ball.y};
}

/// Moves straight back toward the own goal until the ball is `least` away.
Vec2 movedBack(Vec2 p, Vec2 ball, double own_sign, double least) {
  const double dy = p.y - ball.y;
  if (std::abs(dy) >= least || distance(p, ball) >= least) return p;
  return {ball.x + own_sign * std::sqrt(least * least - dy * dy), p.y};
}

/// Law 14 with robots that stay: robots near the mark move back; then the nearest robot of each team takes
/// its mark.
void stayAtFreeBall(const RefereeSetup& setup, const RefereeState& state, const MatchView& view,
                    RestartCall& call) {
  PerTeam<double> nearest{1e9, 1e9};
  PerTeam<std::uint8_t> taker{};
  for (std::size_t i = 0; i < view.ids.size(); ++i) {
    const RobotId id = view.ids[i];
    if (!fielded(setup, state, id.team, id.number)) continue;
    const double own = ownSign(state, id.team);
    Pose2 pose = view.robots[i].pose;
    const Vec2 before = pose.position;
    pose.position = movedBack(before, call.ball, own, setup.rules.free_ball.distance);
    call.rests[indexOf(id.team)][id.number] = pose.position == before;
    call.defaults.robots[indexOf(id.team)][id.number] = pose;
    const double from_mark = distance(pose.position, robotMark(setup, call.ball, own));
    if (from_mark >= nearest[indexOf(id.team)]) continue;
    nearest[indexOf(id.team)] = from_mark;
    taker[indexOf(id.team)] = id.number;
  }
  call.stays = call.defaults.robots;
  if (!setup.rules.free_ball.take_marks) return;
  for (const TeamId team : kTeams) {
    const double own = ownSign(state, team);
    if (nearest[indexOf(team)] > 1e8) continue;
    call.defaults.robots[indexOf(team)][taker[indexOf(team)]] =
        Pose2{robotMark(setup, call.ball, own), headingFor(own)};
  }
}

void placeByTable(const RefereeSetup& setup, const RefereeState& state, RestartCall& call) {
  const PlaceTable& places = placesOf(setup.rules, call.kind);
  for (const TeamId team : kTeams) {
    for (int n = 0; n < setup.rules.team_size; ++n) {
      auto& pose = call.defaults.robots[indexOf(team)][static_cast<std::size_t>(n)];
      if (pose || !fielded(setup, state, team, n)) continue;
      pose = tablePose(setup, call, places, ownSign(state, team), team == call.team, n);
    }
  }
}

}  // namespace

Pose2 goalKickKeeper(const RefereeSetup& setup, double own_sign, Vec2 ball) {
  const GoalKickRules& rules = setup.rules.goal_kick;
  const double side = ball.y < 0.0 ? -1.0 : 1.0;
  const Vec2 listed = rules.places.taker.empty() ? Vec2{0.5, 0.0} : rules.places.taker.front();
  const Vec2 moved = ball - Vec2{own_sign * rules.ball.x, side * rules.ball.y};
  const double most = setup.field.length / 2 - setup.robot.circumradius();
  Vec2 place = Vec2{own_sign * listed.x, side * listed.y} + moved;
  place.x = own_sign * std::min(own_sign * place.x, std::max(most, listed.x));
  return {place, math::wrapAngle(math::angleOf(ball - place))};
}

bool fielded(const RefereeSetup& setup, const RefereeState& state, TeamId team, int number) {
  return setup.present[indexOf(team)] && number < setup.rules.team_size &&
         !state.robots[indexOf(team)][static_cast<std::size_t>(number)].out;
}

RestartCall makeCall(const RefereeSetup& setup, const RefereeState& state, const Stoppage& stoppage) {
  RestartCall call;
  call.kind = stoppage.kind;
  call.team = stoppage.team;
  call.ball = ballSpot(setup, state, stoppage);
  if (call.kind == RestartKind::kFreeBall) {
    // The team that attacks the half with the ball counts as the taking team.
    const Side half = call.ball.x < 0.0 ? Side::kLeft : Side::kRight;
    call.team = state.blue_side == half ? TeamId::kYellow : TeamId::kBlue;
  }
  call.delay = ticksOf(setup.rules.restart.delay, setup.dt);
  call.defaults.ball = call.ball;
  if (call.kind == RestartKind::kFreeBall && setup.rules.free_ball.others == FreeBallOthers::kStay &&
      stoppage.view != nullptr) {
    stayAtFreeBall(setup, state, *stoppage.view, call);
  }
  placeByTable(setup, state, call);
  return call;
}

RestartCall makeShootOutCall(const RefereeSetup& setup, const RefereeState& state, TeamId kicker) {
  RestartCall call = makeCall(setup, state, {RestartKind::kPenalty, kicker, {}, nullptr});
  const int last = setup.rules.team_size - 1;
  for (const TeamId team : kTeams) {
    // The kicker is robot 1 and the keeper robot 0, or whichever robots are left.
    int chosen = team == kicker ? std::min(1, last) : 0;
    for (int n = 0; n <= last && !fielded(setup, state, team, chosen); ++n) chosen = n;
    const double own = ownSign(state, team);
    TeamPoses alone{};
    alone[static_cast<std::size_t>(chosen)] =
        tablePose(setup, call, setup.rules.penalty.places, own, team == kicker, team == kicker ? 1 : 0);
    call.defaults.robots[indexOf(team)] = alone;
  }
  return call;
}

}  // namespace fulbito
