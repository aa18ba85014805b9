#include "strategies/teams/libero/roles.hpp"

#include <cmath>

#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/situation/interception.hpp"

namespace fulbito::libero {
namespace {

/// Whether the ball will be in or near the own area in 0.3 s, with a keeper there. Opponents would push a
/// field player that follows it into the area.
bool ballIsKeepers(const Picture& picture) {
  constexpr double kAhead = 0.3;    // [s]
  constexpr double kMargin = 0.06;  // [m]
  const Vec2 ball = picture.ball.at(kAhead);
  return picture.keeper >= 0 && isInArea(picture.pitch.field, ball, true, kMargin) &&
         std::abs(ball.y) < picture.pitch.area_half;
}

/// While the ball is the keeper's, the striker comes last: the support stays where it is.
void rankOthers(Picture& picture) {
  int rank = 0;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.ownPresent(i) && i != picture.keeper && i != picture.striker)
      picture.rank[static_cast<std::size_t>(i)] = rank++;
  }
  if (picture.striker >= 0) picture.rank[static_cast<std::size_t>(picture.striker)] = rank;
}

}  // namespace

bool Roles::choose(Picture& picture) {
  chooseKeeper(picture);
  const bool changed = chooseStriker(picture);
  picture.keeper = keeper_;
  picture.striker = striker_;
  picture.keepers_ball = ballIsKeepers(picture);
  rankOthers(picture);
  return changed;
}

void Roles::forgetStriker() {
  striker_ = -1;
  held_ = 1.0;
}

// The first present robot is the keeper. If it is alone, it is the keeper only while a shot comes.
void Roles::chooseKeeper(const Picture& picture) {
  int present = 0;
  keeper_ = -1;
  for (int i = picture.seen.team_size - 1; i >= 0; --i) {
    if (picture.ownPresent(i)) ++present, keeper_ = i;
  }
  if (present == 1 && !mustSave(picture, keeper_)) keeper_ = -1;
}

// The striker is the robot that reaches the ball first. The present one stays unless another is clearly
// better.
bool Roles::chooseStriker(Picture& picture) {
  if (picture.seen.playing) held_ += picture.seen.dt;
  // [s] advantage of a striker in their area, which the next one may enter only after it has left
  constexpr double kStays = 0.5;
  // [s] smaller differences are rounding errors, which differ between the two sides
  constexpr double kAlike = 1e-9;
  int best = -1;
  double least = 1e9;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (i == keeper_ || !picture.ownPresent(i)) continue;
    const Interception meet = interception(picture, picture.own(i));
    picture.interceptions[static_cast<std::size_t>(i)] = meet;
    double cost = meet.time;
    if (picture.own(i).pose.position.x > meet.ball.x) cost += 0.3;
    if (i == striker_)
      cost -= isInArea(picture.pitch.field, picture.own(i).pose.position, false, 0.05) ? kStays : 0.2;
    if (cost < least - kAlike) least = cost, best = i;
  }
  if (best == striker_) return false;
  if (striker_ >= 0 && striker_ != keeper_ && picture.ownPresent(striker_) && held_ < 0.4) return false;
  striker_ = best;
  held_ = 0.0;
  return true;
}

}  // namespace fulbito::libero
