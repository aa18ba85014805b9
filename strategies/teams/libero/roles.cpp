#include "strategies/teams/libero/roles.hpp"

#include "strategies/skills/area_projection.hpp"
#include "strategies/teams/libero/defence/goal_line.hpp"
#include "strategies/teams/libero/situation/interception.hpp"

namespace fulbito::libero {
namespace {

/// Numbers the field players without the ball.
void rankOthers(Picture& picture) {
  int rank = 0;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (picture.ownPresent(i) && i != picture.keeper && i != picture.striker)
      picture.rank[static_cast<std::size_t>(i)] = rank++;
  }
}

}  // namespace

bool Roles::choose(Picture& picture) {
  chooseKeeper(picture);
  const bool changed = chooseStriker(picture);
  picture.keeper = keeper_;
  picture.striker = striker_;
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
  const Tuning& tuning = picture.tuning;
  int best = -1;
  double least = 1e9;
  for (int i = 0; i < picture.seen.team_size; ++i) {
    if (i == keeper_ || !picture.ownPresent(i)) continue;
    const Interception meet = interception(picture, picture.own(i));
    picture.interceptions[static_cast<std::size_t>(i)] = meet;
    double cost = meet.time;
    if (picture.own(i).pose.position.x > meet.ball.x) cost += tuning.behind_price;
    // The next striker may enter their area only after this one has left it.
    const bool in_theirs =
        isInArea(picture.pitch.field, picture.own(i).pose.position, false, picture.pitch.robot_corner);
    if (i == striker_) cost -= in_theirs ? 2 * tuning.stays : tuning.stays;
    // Smaller differences are rounding errors, which differ between the two sides.
    if (cost < least - 1e-9) least = cost, best = i;
  }
  if (best == striker_) return false;
  if (striker_ >= 0 && striker_ != keeper_ && picture.ownPresent(striker_) && held_ < 2 * tuning.stays)
    return false;
  striker_ = best;
  held_ = 0.0;
  return true;
}

}  // namespace fulbito::libero
