#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace fulbito {

/// Largest number of robots per team.
inline constexpr int kMaxTeamSize = 11;

/// The two teams of a match.
enum class TeamId : std::uint8_t { kBlue, kYellow };
/// The goal that a team defends: kLeft is the one at -x of the world frame.
enum class Side : std::uint8_t { kLeft, kRight };

constexpr TeamId other(TeamId team) { return team == TeamId::kBlue ? TeamId::kYellow : TeamId::kBlue; }
constexpr Side opposite(Side side) { return side == Side::kLeft ? Side::kRight : Side::kLeft; }
constexpr std::size_t indexOf(TeamId team) { return static_cast<std::size_t>(team); }
inline constexpr std::array<TeamId, 2> kTeams{TeamId::kBlue, TeamId::kYellow};
constexpr const char* nameOf(TeamId team) { return team == TeamId::kBlue ? "blue" : "yellow"; }

/// One robot of a match: its team and its number in the team, from 0.
struct RobotId {
  TeamId team = TeamId::kBlue;
  std::uint8_t number = 0;
  friend bool operator==(RobotId, RobotId) = default;
};

/// One value per team, indexed by `indexOf(team)`.
template <typename T>
using PerTeam = std::array<T, 2>;

}  // namespace fulbito
