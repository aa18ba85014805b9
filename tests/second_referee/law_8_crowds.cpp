#include "tests/second_referee/laws.hpp"

/// Laws 8.2 and 8.3: more attackers, more defenders in a goal area than may be there.
namespace fulbito::second {
namespace {

/// What is counted: attackers or defenders, in the goal area or the big one.
struct Kind {
  bool attack = false;
  bool big = false;
};

bool inside(const Play& play, std::size_t robot, int end, Kind kind) {
  const Moment& now = play.now();
  const bool defends = play.ownEnd(now.players[robot].id.team) == end;
  if (defends == kind.attack) return false;
  return kind.big ? inBigArea(now, robot, end) : inGoalArea(now, robot, end);
}

bool excused(const Moment& now, const Player& player) {
  return player.excused_until && *player.excused_until >= now.tick;
}

/// The robot of an opponent that counts as the one it hinders: for 8.2 the keeper, for 8.3 anybody.
bool hinders(const Play& play, std::size_t at, std::size_t robot, bool attack) {
  const Moment& then = play.moments[at];
  const TeamId rivals = other(then.players[robot].id.team);
  for (const ContactEvent& contact : then.contacts) {
    if (!isPlayer(then, contact.a) || !isPlayer(then, contact.b)) continue;
    const std::size_t a = contact.a.index, b = contact.b.index;
    if (a != robot && b != robot) continue;
    const std::size_t opponent = a == robot ? b : a;
    if (then.players[opponent].id.team != rivals) continue;
    // Who keeps the goal was settled when the tick began; when play began, number 0.
    const bool kept = at == 0 ? then.players[opponent].id.number == 0
                              : play.moments[at - 1].keeper[indexOf(rivals)] == opponent;
    if (!attack || kept) return true;
  }
  return false;
}

bool takesPart(const Play& play, std::size_t robot, bool attack) {
  const AreaRules& rules = play.rules().areas;
  if (!(attack ? rules.attackers_take_part : rules.defenders_take_part)) return true;
  const std::size_t now = play.moments.size() - 1;
  if (touchedBall(play, now, robot, rules.part_seconds)) return true;
  for (std::size_t i = ticksBefore(now, play.ticks(rules.part_seconds)); i <= now; ++i) {
    if (hinders(play, i, robot, attack)) return true;
  }
  return false;
}

int allowed(const AreaRules& rules, Kind kind) {
  if (kind.big) return kind.attack ? rules.big_attackers_max : rules.big_defenders_max;
  return kind.attack ? rules.attackers_max : rules.defenders_max;
}

/// Too many in this area now: a robot that takes part, and as many as may be there came no later.
std::optional<Crowd> crowdIn(const Play& play, int end, Kind kind) {
  const Moment& now = play.now();
  const auto since = [&](std::size_t i) {
    return kind.big ? *now.players[i].in_big_area : *now.players[i].in_goal_area;
  };
  std::vector<std::size_t> counted;
  for (std::size_t i = 0; i < now.players.size(); ++i) {
    if (inside(play, i, end, kind) && !excused(now, now.players[i])) counted.push_back(i);
  }
  for (const std::size_t robot : counted) {
    int earlier = 0;
    for (const std::size_t i : counted) earlier += i != robot && since(i) <= since(robot) ? 1 : 0;
    if (earlier < allowed(play.rules().areas, kind) || !takesPart(play, robot, kind.attack)) continue;
    return Crowd{end, kind.big, robot, now.tick, 0, false};
  }
  return std::nullopt;
}

bool ballIn(const Moment& now, int end, bool big) {
  return now.ballEnd() == end && (big ? now.ball_in_big_area : now.ball_in_goal_area);
}

std::optional<Crowd> crowd(const Play& play, bool attack) {
  const Moment& now = play.now();
  const bool needs_ball = !attack || play.rules().areas.attackers_need_ball;
  for (const int end : {now.ballEnd(), -now.ballEnd()}) {
    for (const bool big : {false, true}) {
      if (needs_ball && !ballIn(now, end, big)) continue;
      if (auto found = crowdIn(play, end, {attack, big})) return found;
    }
  }
  return std::nullopt;
}

/// A foul waits from when it was seen first until it is decided, even if the crowd dissolves.
void wait(const Play& play, bool attack, std::optional<Crowd>& waiting) {
  const auto seen = crowd(play, attack);
  if (!waiting) waiting = seen;
  if (!waiting) return;
  if (seen) ++waiting->seen;
  if (ballIn(play.now(), waiting->end, waiting->big)) waiting->had_ball = true;
}

/// It has waited for its time, or the ball has left the area.
bool due(const Play& play, const std::optional<Crowd>& foul, double seconds) {
  if (!foul) return false;
  if (play.now().tick - foul->since >= play.ticks(seconds)) return true;
  return foul->had_ball && !ballIn(play.now(), foul->end, foul->big);
}

Call callOf(const Play& play, const Crowd& foul, bool attack) {
  const RobotId robot = play.now().players[foul.robot].id;
  return {play.now().tick,
          attack ? "goal-kick.attackers" : "penalty.defenders",
          robot.team,
          robot.number,
          attack ? RestartKind::kGoalKick : RestartKind::kPenalty,
          other(robot.team),
          {}};
}

}  // namespace

void noteCrowds(Play& play) {
  Moment& now = play.moments.back();
  if (play.moments.size() > 1) {
    const Moment& before = play.moments[play.moments.size() - 2];
    now.attack = before.attack;
    now.defence = before.defence;
  }
  const AreaRules& rules = play.rules().areas;
  if (!play.older(now, rules.cool_down)) return;
  if (rules.attackers) wait(play, true, now.attack);
  if (rules.defenders) wait(play, false, now.defence);
}

bool attackCounts(const Play& play, int end) {
  const auto &attack = play.now().attack, &defence = play.now().defence;
  if (!attack || attack->end != end) return false;
  if (!defence || defence->end != end) return true;
  return play.rules().areas.both == BothFouls::kAttackers || attack->seen >= defence->seen;
}

Call attackersCall(const Play& play) { return callOf(play, *play.now().attack, true); }

std::optional<Call> areaFoul(const Play& play) {
  const AreaRules& rules = play.rules().areas;
  const auto &attack = play.now().attack, &defence = play.now().defence;
  const bool attack_due = due(play, attack, rules.attackers_wait);
  const bool defence_due = due(play, defence, rules.defenders_wait);
  if (!attack_due && !defence_due) return std::nullopt;
  const bool at_one_goal = attack && defence && attack->end == defence->end;
  if (at_one_goal ? attackCounts(play, attack->end) : attack_due) return attackersCall(play);
  return callOf(play, *defence, false);
}

}  // namespace fulbito::second
