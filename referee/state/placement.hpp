#pragma once

#include <array>
#include <optional>

#include "engine/core/base/team.hpp"
#include "engine/core/base/values.hpp"

namespace fulbito {

/// Poses of one team's robots by number. A robot without a pose is not on the field.
using TeamPoses = std::array<std::optional<Pose2>, kMaxTeamSize>;

/// Positions of ball and robots in the world frame. A robot without a pose is not on the field.
struct Placement {
  Vec2 ball;
  Vec2 ball_velocity;  ///< [m/s] 0 at every restart of the rules
  PerTeam<TeamPoses> robots;
};

}  // namespace fulbito
