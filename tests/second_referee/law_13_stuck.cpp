#include <cmath>

#include "tests/second_referee/laws.hpp"

/// Laws 13 and 14: the ball that does not get away.
namespace fulbito::second {
namespace {

/// In this tick the ball is free to go or has got away: the count begins anew, or there is none.
bool gotAway(const Play& play, const Moment& now, Standstill& count) {
  const StuckRules& rules = play.rules().stuck;
  const double speed = std::hypot(now.ball_velocity.x, now.ball_velocity.y);
  if (rules.measure == StuckMeasure::kRadius) {
    const Vec2 off = now.ball - count.from;
    return !count.counting || std::hypot(off.x, off.y) > rules.radius;
  }
  if (!count.counting) return speed <= rules.speed;
  count.fast = speed > rules.release_speed ? count.fast + 1 : 0;
  if (count.fast > 0 && count.fast >= play.ticks(rules.release_seconds)) count.counting = false;
  return false;
}

}  // namespace

void noteStandstill(Play& play) {
  Moment& now = play.moments.back();
  Standstill count;
  if (play.moments.size() > 1) count = play.moments[play.moments.size() - 2].standstill;
  if (gotAway(play, now, count)) count = {true, now.ball, 0, 0, 0};
  // What the keeper has for itself is law 8.1's: the stalemate does not count it.
  if (count.counting && undisputedControl(play, play.moments.size() - 1) != Beat::kYes) {
    ++count.ticks;
    if (now.ball_in_goal_area) ++count.inside;
  }
  now.standstill = count;
}

std::optional<Call> stuckBall(const Play& play) {
  const StuckRules& rules = play.rules().stuck;
  const Moment& now = play.now();
  const Standstill& count = now.standstill;
  if (!count.counting || undisputedControl(play, play.moments.size() - 1) == Beat::kYes) return std::nullopt;
  const bool in_area =
      rules.place == StuckPlace::kMost ? 2 * count.inside >= count.ticks : now.ball_in_goal_area;
  // The first tick is when it began: after it, so many more.
  if (count.ticks - 1 < play.ticks(in_area ? rules.area_seconds : rules.seconds)) return std::nullopt;
  const TeamId defenders = play.defenderAt(now.ballEnd()), attackers = other(defenders);
  if (!in_area) {
    const TeamId takes = now.ball.x == 0.0 ? other(play.begun_by) : attackers;
    return Call{now.tick, "free-ball", std::nullopt, std::nullopt, RestartKind::kFreeBall, takes, {}};
  }
  const bool disputed = nearBall(play, now, defenders, rules.dispute_lengths) &&
                        nearBall(play, now, attackers, rules.dispute_lengths);
  if (disputed || rules.undisputed == UndisputedCall::kGoalKick) {
    return Call{now.tick, "goal-kick.stuck", attackers, std::nullopt, RestartKind::kGoalKick, defenders, {}};
  }
  return Call{now.tick, "penalty.stuck", defenders, std::nullopt, RestartKind::kPenalty, attackers, {}};
}

}  // namespace fulbito::second
