#include <cmath>

#include "tests/second_referee/laws.hpp"

/// Law 7.2: when a kick of the shoot-out is over.
namespace fulbito::second {
namespace {

constexpr double kOffItsMark = 0.005;  // [m] from here on the ball has been kicked

/// At which end the kicker's goal is.
int attackedEnd(const Play& play) { return play.ownEnd(other(play.begun_by)); }

bool ballInArea(const Play& play, const Moment& then) {
  const Marking area = goalArea(play.match->field, play.rules().areas.arc);
  return isIn(area, atEnd(play.match->field, attackedEnd(play), then.ball));
}

/// The keeper alone has the ball, both in the area.
bool held(const Play& play, const Moment& then) {
  const KeeperRules& rules = play.rules().keeper;
  if (!ballInArea(play, then) || nearBall(play, then, play.begun_by, rules.dispute_lengths)) return false;
  const Marking area = goalArea(play.match->field, play.rules().areas.arc);
  for (const Player& player : then.players) {
    if (player.id.team == play.begun_by) continue;
    const double gap =
        gapBetween(player.pose, play.body().length, play.body().width, then.ball, play.ballRadius());
    if (gap <= rules.control_gap &&
        bodyIn(area, play, player.pose, attackedEnd(play), play.rules().areas.defenders_part)) {
      return true;
    }
  }
  return false;
}

bool rests(const Play& play, const Moment& then) {
  const Vec2 v = then.ball_velocity, off = then.ball - play.mark;
  return std::hypot(v.x, v.y) <= play.rules().shoot_out.rest_speed && std::hypot(off.x, off.y) > kOffItsMark;
}

/// In each of the ticks of so many seconds up to now.
bool throughout(const Play& play, double seconds, bool (*what)(const Play&, const Moment&)) {
  const auto ticks = static_cast<std::size_t>(std::max<Tick>(1, play.ticks(seconds)));
  if (play.moments.size() < ticks) return false;
  for (std::size_t i = play.moments.size() - ticks; i < play.moments.size(); ++i) {
    if (!what(play, play.moments[i])) return false;
  }
  return true;
}

bool cameBackOut(const Play& play) {
  if (ballInArea(play, play.now())) return false;
  for (const Moment& then : play.moments) {
    if (ballInArea(play, then)) return true;
  }
  return false;
}

}  // namespace

std::optional<bool> kickOver(const Play& play) {
  const ShootOutRules& rules = play.rules().shoot_out;
  const double x = attackedEnd(play) * play.now().ball.x;
  const double ball = play.rules().goal.ball == BallPart::kWhole ? play.ballRadius() : 0.0;
  if (x > play.match->field.length / 2 + ball) return true;
  const bool over = (rules.held_seconds > 0.0 && throughout(play, rules.held_seconds, held)) ||
                    (rules.ends_leaving_area && cameBackOut(play)) || (rules.ends_past_midfield && x < 0.0) ||
                    (rules.ends_at_rest && throughout(play, rules.rest_seconds, rests)) ||
                    static_cast<Tick>(play.moments.size()) >= play.ticks(rules.kick_seconds);
  if (over) return false;
  return std::nullopt;
}

}  // namespace fulbito::second
