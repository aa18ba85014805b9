#pragma once

#include <string_view>

/// Names of the referee's calls in events, recordings and tables.
namespace fulbito::clause {

inline constexpr std::string_view kGoal = "goal";
inline constexpr std::string_view kFreeBall = "free-ball";
inline constexpr std::string_view kAttackers = "goal-kick.attackers";
inline constexpr std::string_view kKeeperCharged = "goal-kick.keeper-charged";
inline constexpr std::string_view kGoalKickStuck = "goal-kick.stuck";
inline constexpr std::string_view kDefenders = "penalty.defenders";
inline constexpr std::string_view kKeeperHolds = "penalty.keeper-holds";
inline constexpr std::string_view kPenaltyHolding = "penalty.holding";
inline constexpr std::string_view kPenaltyStuck = "penalty.stuck";
inline constexpr std::string_view kPush = "free-kick.push";
inline constexpr std::string_view kFreeKickHolding = "free-kick.holding";

/// Whether the call is a foul of the team that it is against.
constexpr bool isFoul(std::string_view clause) {
  return clause.starts_with("goal-kick.") || clause.starts_with("penalty.") ||
         clause.starts_with("free-kick.") || clause == "false-start";
}

}  // namespace fulbito::clause
