#pragma once

#include "strategies/teams/libero/situation/move.hpp"
#include "strategies/teams/libero/situation/picture.hpp"

namespace fulbito::libero {

/// Who keeps goal and who goes for the ball; all others support.
class Roles {
 public:
  /// Chooses the roles of this tick and adds them to `picture`. Returns whether another robot is striker now.
  bool choose(Picture& picture);
  /// The next choice is free: no robot has been striker.
  void forgetStriker();

  /// The role of a robot since the last choice.
  Role of(int robot) const {
    return robot == keeper_ ? Role::kKeeper : robot == striker_ ? Role::kStriker : Role::kSupport;
  }

 private:
  void chooseKeeper(const Picture& picture);
  bool chooseStriker(Picture& picture);

  int keeper_ = -1;
  int striker_ = -1;
  double held_ = 1.0;  // [s] since the striker was chosen
};

}  // namespace fulbito::libero
