#include <algorithm>
#include <cmath>

#include "tests/second_referee/laws.hpp"

namespace fulbito::second {

Tick Play::ticks(double seconds) const { return std::lround(seconds / dt); }

bool isPlayer(const Moment& moment, BodyId body) {
  return body.kind == BodyKind::kRobot && body.index < moment.players.size();
}

bool touchesBall(const Moment& moment, std::size_t robot) {
  for (const ContactEvent& contact : moment.contacts) {
    if (contact.b.kind == BodyKind::kBall && isPlayer(moment, contact.a) && contact.a.index == robot)
      return true;
  }
  return false;
}

std::size_t ticksBefore(std::size_t at, Tick ticks) {
  return at - std::min(at, static_cast<std::size_t>(ticks));  // every tick of play is a moment
}

bool touchedBall(const Play& play, std::size_t at, std::size_t robot, double seconds) {
  for (std::size_t i = ticksBefore(at, play.ticks(seconds)); i <= at; ++i) {
    if (touchesBall(play.moments[i], robot)) return true;
  }
  return false;
}

bool nearBall(const Play& play, const Moment& moment, TeamId team, double lengths) {
  for (const Player& player : moment.players) {
    const Vec2 off = player.pose.position - moment.ball;
    if (player.id.team == team && std::hypot(off.x, off.y) <= lengths * play.body().length) return true;
  }
  return false;
}

bool inGoalArea(const Moment& moment, std::size_t robot, int end) {
  const Player& player = moment.players[robot];
  return player.in_goal_area && (player.pose.position.x < 0.0 ? -1 : 1) == end;
}

bool inBigArea(const Moment& moment, std::size_t robot, int end) {
  const Player& player = moment.players[robot];
  return player.in_big_area && (player.pose.position.x < 0.0 ? -1 : 1) == end;
}

bool keepsGoal(const Play& play, const Moment& moment, std::size_t robot) {
  const TeamId team = moment.players[robot].id.team;
  return moment.keeper[indexOf(team)] == robot && inGoalArea(moment, robot, play.ownEnd(team));
}

Tick lasted(const Play& play, Tick release, const std::function<Beat(std::size_t)>& beat) {
  const std::size_t now = play.moments.size() - 1;
  if (beat(now) != Beat::kYes) return 0;
  Tick first = play.moments[now].tick, pause = 0;
  for (std::size_t i = now; i-- > 0;) {
    const Beat then = beat(i);
    if (then == Beat::kEnd) break;
    if (then == Beat::kPause && ++pause > release) break;
    if (then == Beat::kYes) first = play.moments[i].tick, pause = 0;
  }
  return play.moments[now].tick - first + 1;
}

}  // namespace fulbito::second
