#include "strategies/teams/libero/situation/stalls.hpp"

#include <algorithm>

#include "fulbito/detail/math.hpp"

namespace fulbito::libero {
namespace {

/// Whether no opponent is at the ball, and those on the way from it leave. Others let go of it for a moment,
/// too, but seldom all together.
bool opponentsWithdraw(const Picture& picture) {
  const Tuning& tuning = picture.tuning;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (!picture.opponentPresent(i)) continue;
    const Vec2 off = picture.opponent(i).pose.position - picture.ball.now().position;
    const double away = norm(off);
    if (away < tuning.rival_near) return false;
    if (away < 2 * tuning.rival_near && dot(picture.opponent(i).velocity, off) < tuning.lies * away)
      return false;
  }
  return true;
}

}  // namespace

void Stalls::watch(const Picture& picture) {
  const double dt = picture.seen.dt;
  withdrawing_ = std::max(0.0, withdrawing_ - dt);
  watching_ = std::max(0.0, watching_ - dt);
  // The ball counts as stuck anew from each restart.
  if (!picture.seen.playing) {
    withdrawing_ = watching_ = 0.0;
    return;
  }
  // A disputed free ball is a chance to throw the ball across.
  if (picture.disputesFreeBall()) return;
  const double after = stallsAfter(picture);
  if (picture.stuck > after && picture.stuck - dt <= after &&
      picture.opponentsNear(picture.ball.now().position, picture.tuning.rival_near) > 0)
    begin(picture, picture.tuning.patience + 2 * picture.pitch.turn_time);
  if (watching_ > 0.0) watchOpponents(picture);
  if (withdrawing_ > 0.0 && endsWithdrawal(picture)) withdrawing_ = 0.0;
}

/// The time [s] after which the ball counts as stalled. Once the opponents are known to withdraw, robots that
/// can shove leave it as soon as it jams: they are away sooner. So our own stalls count from then, too.
double Stalls::stallsAfter(const Picture& picture) const {
  const bool early = areKnownToWithdraw() || picture.ball.now().position.x < 0.0;
  return picture.pitch.shoves && early ? picture.tuning.jam_time : picture.tuning.patience / 4;
}

/// Some stalls go first, or nobody would begin: two where robots cannot shove, as an offer costs less there.
/// Some of the stalls that they give up escape notice, since the ball leaves at once, so three count for
/// each. Leaning on may be a mishap once.
bool Stalls::opponentsDoToo(const Pitch& pitch) const {
  const int first = pitch.shoves ? 1 : 2;
  return given_ < first + 3 * taken_ && leaned_ < 2 + taken_;
}

/// Opponents that have given up none get the ball only where it is far from our goal.
void Stalls::begin(const Picture& picture, double horizon) {
  const Vec2 ball = picture.ball.now().position;
  if (ball.x < 0.0) {
    watching_ = horizon;
  } else if (opponentsDoToo(picture.pitch) && (taken_ > 0 || ball.x > 0.5 * picture.pitch.half_length)) {
    withdrawing_ = horizon;
    place_ = ball;
    ++given_;
  }
}

void Stalls::watchOpponents(const Picture& picture) {
  const bool withdraw = opponentsWithdraw(picture);
  if (withdraw) ++taken_;
  const bool leans = picture.stuck > picture.tuning.patience;
  if (leans && !withdraw) ++leaned_;
  if (withdraw || leans) watching_ = 0.0;
}

/// The withdrawal ends once the ball has left, and is an offer to play on. Where robots can shove, both would
/// then only be at the next wall. So there it lasts, once the opponents are known to withdraw, until the ball
/// comes near our goal.
bool Stalls::endsWithdrawal(const Picture& picture) const {
  const Tuning& tuning = picture.tuning;
  const Vec2 ball = picture.ball.now().position;
  const bool lasts = picture.pitch.shoves && areKnownToWithdraw();
  return ball.x < -0.5 * picture.pitch.half_length ||
         picture.opponentsNear(ball, 2 * tuning.rival_far) == 0 ||
         (!lasts && distance(ball, place_) > tuning.behind);
}

}  // namespace fulbito::libero
