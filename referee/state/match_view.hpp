#pragma once

#include <span>

#include "engine/core/base/contact.hpp"
#include "engine/core/base/team.hpp"
#include "engine/core/base/values.hpp"

namespace fulbito {

/// What a match referee sees of one tick, in the world's frame. Views stay valid during the call only.
struct MatchView {
  Tick tick = 0;                       ///< of the match: never reset by a restart
  std::span<const RobotId> ids;        ///< of `robots`, in the same order
  std::span<const RobotState> robots;  ///< on the field; one that was sent off is not in the list
  BallState ball;
  std::span<const ContactEvent> contacts;  ///< robot indices count `robots`
};

}  // namespace fulbito
