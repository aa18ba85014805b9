#include "tests/second_referee/laws.hpp"

/// Laws 8.1 and 13: the keeper that holds the ball for too long, and the opponent that charges or blocks it.
namespace fulbito::second {
namespace {

/// Impulse [kg m/s] of the robot's contact with the opponents' keeper in that one's area; 0: there is none.
double pressOnKeeper(const Play& play, const Moment& then, const ContactEvent& contact, std::size_t robot) {
  if (!isPlayer(then, contact.a) || !isPlayer(then, contact.b)) return 0.0;
  if (contact.a.index != robot && contact.b.index != robot) return 0.0;
  const std::size_t opponent = contact.a.index == robot ? contact.b.index : contact.a.index;
  const TeamId rivals = then.players[opponent].id.team;
  if (rivals == then.players[robot].id.team || !keepsGoal(play, then, opponent)) return 0.0;
  const Marking area = goalArea(play.match->field, play.rules().areas.arc);
  return isIn(area, atEnd(play.match->field, play.ownEnd(rivals), contact.point)) ? contact.impulse : 0.0;
}

double pressOnKeeper(const Play& play, const Moment& then, std::size_t robot) {
  double sum = 0.0;
  for (const ContactEvent& contact : then.contacts) sum += pressOnKeeper(play, then, contact, robot);
  return sum;
}

/// Whether what the robot does to the keeper now is a charge.
bool charges(const Play& play, std::size_t robot) {
  const KeeperRules& rules = play.rules().keeper;
  const auto beat = [&](std::size_t i) {
    const Moment& then = play.moments[i];
    if (!play.older(then, rules.cool_down)) return Beat::kEnd;
    if (pressOnKeeper(play, then, robot) <= 0.0) return Beat::kPause;
    return touchedBall(play, i, robot, rules.part_seconds) ? Beat::kEnd : Beat::kYes;
  };
  const Tick ticks = lasted(play, play.ticks(rules.charge_release), beat);
  double sum = 0.0;
  for (const Moment& then : play.moments) {
    if (play.now().tick - then.tick < ticks) sum += pressOnKeeper(play, then, robot);
  }
  return ticks > 0 && ticks >= play.ticks(rules.charge_seconds) && sum >= rules.charge_impulse;
}

}  // namespace

std::optional<Call> keeperCharged(const Play& play) {
  const Moment& now = play.now();
  if (!play.rules().keeper.charged) return std::nullopt;
  // Of several the one whose contact comes first.
  for (const ContactEvent& contact : now.contacts) {
    for (const BodyId body : {contact.a, contact.b}) {
      if (!isPlayer(now, body) || pressOnKeeper(play, now, contact, body.index) <= 0.0) continue;
      if (!charges(play, body.index)) continue;
      const RobotId robot = now.players[body.index].id;
      return Call{now.tick,
                  "goal-kick.keeper-charged",
                  robot.team,
                  robot.number,
                  RestartKind::kGoalKick,
                  other(robot.team),
                  {}};
    }
  }
  return std::nullopt;
}

Beat undisputedControl(const Play& play, std::size_t at) {
  const Moment& then = play.moments[at];
  const KeeperRules& rules = play.rules().keeper;
  const int end = play.now().ballEnd();
  const TeamId team = play.defenderAt(end);
  const auto keeper = then.keeper[indexOf(team)];
  if (!rules.holding || then.ballEnd() != end || !then.ball_in_goal_area) return Beat::kEnd;
  if (!keeper || !keepsGoal(play, then, *keeper)) return Beat::kEnd;
  if (nearBall(play, then, other(team), rules.dispute_lengths)) return Beat::kEnd;
  const double gap = gapBetween(then.players[*keeper].pose, play.body().length, play.body().width, then.ball,
                                play.ballRadius());
  return gap <= rules.control_gap ? Beat::kYes : Beat::kPause;
}

std::optional<Call> keeperHolds(const Play& play) {
  const KeeperRules& rules = play.rules().keeper;
  const Moment& now = play.now();
  if (!play.older(now, rules.cool_down)) return std::nullopt;
  const Tick held = lasted(play, play.ticks(rules.release_seconds),
                           [&](std::size_t i) { return undisputedControl(play, i); });
  if (held <= play.ticks(rules.hold_seconds)) return std::nullopt;
  const TeamId team = play.defenderAt(now.ballEnd());
  return Call{now.tick,
              "penalty.keeper-holds",
              team,
              now.players[*now.keeper[indexOf(team)]].id.number,
              RestartKind::kPenalty,
              other(team),
              {}};
}

}  // namespace fulbito::second
