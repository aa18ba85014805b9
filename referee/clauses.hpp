#pragma once

#include <string_view>

/// Names of the rules that a referee calls, as they stand in events, recordings and tables.
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

}  // namespace fulbito::clause
