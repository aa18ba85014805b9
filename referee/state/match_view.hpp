#pragma once

#include <span>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A match referee's view of one tick, in the world frame. The spans are valid during the call only.
struct MatchView {
  Tick tick = 0;                       ///< of the match: never reset by a restart
  std::span<const RobotId> ids;        ///< of `robots`, in the same order
  std::span<const RobotState> robots;  ///< robots on the field, without those sent off
  BallState ball;
  std::span<const ContactEvent> contacts;  ///< robot indices count `robots`
};

}  // namespace fulbito
