#include <cmath>

#include "tests/second_referee/laws.hpp"

/// Law 7.1: the whole ball over the goal line, between the posts.
namespace fulbito::second {
namespace {

/// Who of the team touched the ball last, if not too long ago; of several in one tick the first of the list.
std::optional<int> scorer(const Play& play, TeamId team) {
  const std::size_t now = play.moments.size() - 1;
  const std::size_t earliest = ticksBefore(now, play.ticks(play.rules().goal.scorer_seconds));
  for (std::size_t after = now + 1; after > earliest; --after) {
    const Moment& then = play.moments[after - 1];
    for (std::size_t robot = 0; robot < then.players.size(); ++robot) {
      if (then.players[robot].id.team == team && touchesBall(then, robot))
        return then.players[robot].id.number;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Call> goal(const Play& play) {
  const Moment& now = play.now();
  const GoalRules& rules = play.rules().goal;
  const double line = play.match->field.length / 2;
  const double needed = line + (rules.ball == BallPart::kWhole ? play.ballRadius() : 0.0);
  if (std::abs(now.ball.x) <= needed) return std::nullopt;
  if (std::abs(now.ball.y) >= play.match->field.goal_width / 2) return std::nullopt;
  if (rules.attack_foul_voids && attackCounts(play, now.ballEnd())) return attackersCall(play);
  const TeamId conceded = play.defenderAt(now.ballEnd()), team = other(conceded);
  return Call{now.tick, "goal", team, scorer(play, team), RestartKind::kKickOff, conceded, {}};
}

}  // namespace fulbito::second
