#include <algorithm>
#include <cmath>

#include "tests/second_referee/laws.hpp"

/// Law 8.1, where a profile calls it: a robot that pins the ball to a wall, and one that pushes an opponent
/// away from the ball.
namespace fulbito::second {
namespace {

double speed(Vec2 v) { return std::hypot(v.x, v.y); }

bool pins(const Play& play, const Moment& then, std::size_t robot) {
  const FoulRules& rules = play.rules().fouls;
  bool wall = false;
  for (const ContactEvent& contact : then.contacts) {
    if (contact.a.kind == BodyKind::kWall && contact.b.kind == BodyKind::kBall) wall = true;
  }
  return wall && touchesBall(then, robot) && !keepsGoal(play, then, robot) &&
         speed(then.ball_velocity) <= rules.pinned_speed &&
         speed(then.players[robot].velocity) <= rules.pinned_speed &&
         !nearBall(play, then, other(then.players[robot].id.team), rules.dispute_lengths);
}

bool farFromBall(const Play& play, std::size_t at, std::size_t robot) {
  const Moment& then = play.moments[at];
  const FoulRules& rules = play.rules().fouls;
  return speed(then.players[robot].pose.position - then.ball) > rules.push_distance &&
         !touchedBall(play, at, robot, rules.part_seconds);
}

/// Who of the two drives the other before it in this contact, both away from the ball.
std::optional<std::size_t> pusher(const Play& play, std::size_t at, const ContactEvent& contact) {
  const Moment& then = play.moments[at];
  if (!isPlayer(then, contact.a) || !isPlayer(then, contact.b)) return std::nullopt;
  const std::size_t a = contact.a.index, b = contact.b.index;
  if (then.players[a].id.team == then.players[b].id.team) return std::nullopt;
  if (!farFromBall(play, at, a) || !farFromBall(play, at, b)) return std::nullopt;
  const double least = play.rules().fouls.push_speed;
  if (dot(then.players[b].velocity, contact.normal) >= least) return a;
  if (-dot(then.players[a].velocity, contact.normal) >= least) return b;
  return std::nullopt;
}

double pushBy(const Play& play, std::size_t at, std::size_t robot) {
  double sum = 0.0;
  for (const ContactEvent& contact : play.moments[at].contacts) {
    if (pusher(play, at, contact) == robot) sum += contact.impulse;
  }
  return sum;
}

}  // namespace

std::optional<Call> pinnedToWall(const Play& play) {
  const FoulRules& rules = play.rules().fouls;
  const Moment& now = play.now();
  if (!rules.holding) return std::nullopt;
  for (std::size_t robot = 0; robot < now.players.size(); ++robot) {
    const Tick ticks = lasted(play, play.ticks(rules.holding_release), [&](std::size_t i) {
      if (!play.older(play.moments[i], rules.cool_down)) return Beat::kEnd;
      return pins(play, play.moments[i], robot) ? Beat::kYes : Beat::kPause;
    });
    if (ticks <= play.ticks(rules.pinned_seconds)) continue;
    const RobotId id = now.players[robot].id;
    const bool own = now.ball_in_goal_area && now.ballEnd() == play.ownEnd(id.team);
    return Call{now.tick,  own ? "penalty.holding" : "free-kick.holding",        id.team,
                id.number, own ? RestartKind::kPenalty : RestartKind::kFreeKick, other(id.team),
                {}};
  }
  return std::nullopt;
}

std::optional<Call> pushedAway(const Play& play) {
  const FoulRules& rules = play.rules().fouls;
  const Moment& now = play.now();
  if (!rules.push) return std::nullopt;
  for (const ContactEvent& contact : now.contacts) {
    const auto robot = pusher(play, play.moments.size() - 1, contact);
    if (!robot) continue;
    const Tick ticks = lasted(play, play.ticks(rules.push_release), [&](std::size_t i) {
      if (!play.older(play.moments[i], rules.cool_down)) return Beat::kEnd;
      return pushBy(play, i, *robot) > 0.0 ? Beat::kYes : Beat::kPause;
    });
    double sum = 0.0;
    const std::size_t last = play.moments.size() - 1;
    for (std::size_t i = ticksBefore(last, std::max<Tick>(0, ticks - 1)); i <= last; ++i) {
      sum += pushBy(play, i, *robot);
    }
    if (ticks < play.ticks(rules.push_seconds) || sum < rules.push_impulse) continue;
    const RobotId id = now.players[*robot].id;
    return Call{now.tick, "free-kick.push", id.team, id.number, RestartKind::kFreeKick, other(id.team), {}};
  }
  return std::nullopt;
}

}  // namespace fulbito::second
