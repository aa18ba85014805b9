#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "fulbito/strategy.hpp"
#include "fulbito/team.h"
#include "navigation/library/plugin_values.hpp"

/// Conversions of a team's values to the C interface (`toAbi`) and of its answers back (`fromAbi`). They
/// accept any bytes. The conversions of structures are generated from sdk/values/values.toml.
namespace fulbito {

/// @{ To a team. `to` was made by the same function or is zero: members named `reserved` are not written.
void toAbi(const BallModel& v, fulbito_ball_model& to);
void toAbi(const PhysicsProfile& v, fulbito_physics& to);
void toAbi(const Rules& v, fulbito_rules& to);
void toAbi(const MatchInfo& v, fulbito_match_info& to);
void toAbi(const BallState& v, fulbito_ball& to);
void toAbi(const Observation& v, fulbito_observation& to);
void toAbi(const GoTo& v, fulbito_go_to& to);  ///< all but the heading
void toAbi(const GameEvent& v, fulbito_call& to);
void toAbi(const PlacementRequest& v, fulbito_placement_request& to);
void toAbi(const PlayStop& v, fulbito_stop& to);
void toAbi(const MatchEnd& v, fulbito_end& to);
void toAbi(const Exercise& v, fulbito_exercise& to);

/// Poses by robot number.
inline void toAbi(const TeamPlacement& from, fulbito_poses& to) {
  to = {};
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (from[i]) to.present[i] = 1, toAbi(*from[i], to.pose[i]);
  }
}
/// Number of robots per team in an observation, 0 ... `kMaxTeamSize`.
inline int robotsOf(const Observation& seen) { return std::clamp(seen.team_size, 0, kMaxTeamSize); }
/// The items of the first `count` robots.
template <typename T>
struct PerRobot {
  const std::array<T, kMaxTeamSize>& items;  ///< by number
  int count;                                 ///< robots per team
};
inline void toAbi(const ObservedRobot& from, fulbito_robot& to) {
  from.present ? toAbi(from.state, to) : static_cast<void>(to = {});
}
template <typename T, typename C>
void toAbi(PerRobot<T> from, C (&to)[FULBITO_MAX_ROBOTS]) {
  for (int i = 0; i < from.count; ++i) toAbi(from.items[static_cast<std::size_t>(i)], to[i]);
}
/// @}

inline constexpr std::uint32_t kMostDrawings = 512;  ///< most drawings of a team per tick

/// The memory of a team's commands.
class CommandRoom {
 public:
  CommandRoom();
  /// The command before the team fills it in: all robots stand still.
  fulbito_team_command open(bool drawings_wanted);
  /// Restores what a team must not change: the address and the capacity of its drawings.
  void close(fulbito_team_command& command);

 private:
  std::vector<fulbito_drawing> drawings_;
  fulbito_team_command still_{};
};

/// @{ From a team. `to` keeps its memory; commands of robots from `team_size` on are not read.
void fromAbi(const fulbito_team_command& command, int team_size, TeamCommand& to);
TeamProposal fromAbi(const fulbito_placement& placement);
void fromAbi(const fulbito_go_to& from, GoTo& to);  ///< all but the heading
inline void fromAbi(double from, double& to) { to = from; }
inline void fromAbi(fulbito_vec2 from, Vec2& to) { to = {from.x, from.y}; }
inline void fromAbi(std::uint8_t from, bool& to) { to = from != 0; }
inline void fromAbi(std::uint8_t from, std::uint8_t& to) { to = from; }
/// @}

}  // namespace fulbito
