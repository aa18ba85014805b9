#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/core/field_geometry.hpp"
#include "engine/core/physics_profile.hpp"
#include "engine/core/presets.hpp"
#include "engine/core/team.hpp"
#include "referee/placement.hpp"
#include "referee/rules.hpp"
#include "strategies/registry.hpp"

namespace fulbito {

/// Seed that is used where none is given.
inline constexpr std::uint64_t kDefaultMatchSeed = 1;

/// How well the teams see.
struct VisionModel {
  int latency_ticks = 0;        ///< age of every observation, 0 ... 60
  double position_noise = 0.0;  ///< [m] standard deviation of positions
  double heading_noise = 0.0;   ///< [rad] standard deviation of headings
  double dropout = 0.0;         ///< chance that a body is not seen in a tick: its last sight stays
};

/// Everything a match is made from. Equal configurations give equal matches, bit for bit.
struct MatchConfig {
  PerTeam<TeamChoice> teams;  ///< blue defends the left goal at first
  Rules rules;
  FieldGeometry field;
  RobotPreset robot;
  PhysicsProfile physics;
  VisionModel vision;
  std::uint64_t seed = kDefaultMatchSeed;
  std::optional<Placement> start;  ///< instead of the first kick-off
};

}  // namespace fulbito
