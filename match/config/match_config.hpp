#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "engine/core/base/team.hpp"
#include "engine/core/config/presets.hpp"
#include "engine/core/models/field_geometry.hpp"
#include "engine/core/models/physics_profile.hpp"
#include "engine/core/models/sensor_model.hpp"
#include "referee/rules/rules.hpp"
#include "referee/state/placement.hpp"
#include "referee/state/referee_state.hpp"
#include "referee/state/scoreboard.hpp"
#include "strategies/registry.hpp"

namespace fulbito {

/// Seed that is used where none is given.
inline constexpr std::uint64_t kDefaultMatchSeed = 1;

/// How well a team sees. Every seat (blue, yellow) has random numbers of its own. How noise makes velocities
/// uncertain, and what a drop-out does: docs/matches.md.
using VisionModel = SensorModel;

/// How exactly robots stand at a restart of the rules: uniform errors up to these, drawn from the match's
/// seed. Without them, teams that draw no numbers would play the same match whatever the seed.
struct PlacementError {
  double position = 0.002;  ///< [m] along x and y, 0 ... 0.01
  double heading = 0.02;    ///< [rad], 0 ... 0.2
};

/// Everything a match is made from. Equal configurations give equal matches, bit for bit, unless decisions
/// come too late (`decision_time`).
struct MatchConfig {
  PerTeam<TeamChoice> teams;  ///< blue defends the left goal at first
  Rules rules;
  FieldGeometry field;
  RobotPreset robot;
  PhysicsProfile physics;
  PerTeam<VisionModel> vision;
  PlacementError placement_error;
  std::uint64_t seed = kDefaultMatchSeed;
  /// How long the teams may think by the clock of `Match::create`; empty: as long as they like.
  std::optional<DecisionTime> decision_time;
  PerTeam<bool> present{true, true};  ///< false: the team did not come (law 7.3)
  std::optional<Placement> start;     ///< instead of the first kick-off; taken exactly, never repaired
  /// The first restart instead of the kick-off. With a `start`, only its kind and team count, and are told.
  std::optional<RestartCall> opening;
  Scoreboard scoreboard;  ///< how the match stands at its beginning

  /// A match that can be played as it is: teams by their specifications (`parseTeam`), rules by preset or file
  /// (`loadRules`), the field that these name, the robot preset `vsss`, the physics preset `standard`. What is
  /// special about a match is set in the result. Errors: as those functions and `loadField`.
  static Result<MatchConfig> standard(const std::string& blue, const std::string& yellow,
                                      const std::string& rules = "vsss-3v3");
};

}  // namespace fulbito
