#pragma once

#include <array>
#include <cstdint>
#include <string_view>

/// The referee's calls: their names in events, recordings and tables, and the words for each.
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
inline constexpr std::string_view kMercy = "mercy";

/// Whether the call is a foul of the team that it is against.
constexpr bool isFoul(std::string_view clause) {
  return clause.starts_with("goal-kick.") || clause.starts_with("penalty.") ||
         clause.starts_with("free-kick.") || clause == "false-start";
}

/// How a call's measured value is shown, e.g. "pressed with 0.12 N s".
struct Measure {
  std::string_view before;
  std::string_view unit;
  double scale = 1.0;  ///< factor from the value to `unit`
};

inline constexpr Measure kStood{"for ", "s"};
inline constexpr Measure kInside{"robots inside: ", ""};
inline constexpr Measure kPressed{"pressed with ", "N s"};
inline constexpr Measure kMoved{"moved by ", "mm", 1e3};
inline constexpr Measure kLead{"lead of ", "goals"};

/// The team that a call favours, relative to the team of its event.
enum class Gain : std::uint8_t { kNobody, kNamed, kOther };

/// The words for a call in pictures, films, pages and tables.
struct Clause {
  std::string_view name;    ///< as in events
  std::string_view title;   ///< empty: the call needs no banner
  std::string_view detail;  ///< may be empty
  Gain gain = Gain::kNobody;
  Measure measure = {};
};

/// Every call that a match can have.
inline constexpr std::array kClauses{
    Clause{kGoal, "Goal!", "", Gain::kNamed, {"ball past the line by ", "mm", 1e3}},
    Clause{"kick-off", "", "", Gain::kNamed},
    Clause{kFreeBall, "Free ball", "stuck ball", Gain::kNobody, kStood},
    Clause{kAttackers, "Goal kick", "too many attackers in the area", Gain::kOther, kInside},
    Clause{kKeeperCharged, "Goal kick", "keeper charged", Gain::kOther, kPressed},
    Clause{kGoalKickStuck, "Goal kick", "ball stuck in the area", Gain::kOther, kStood},
    Clause{kDefenders, "Penalty", "too many defenders in the area", Gain::kOther, kInside},
    Clause{kKeeperHolds, "Penalty", "keeper held the ball", Gain::kOther, kStood},
    Clause{kPenaltyHolding, "Penalty", "ball held", Gain::kOther, kStood},
    Clause{kPenaltyStuck, "Penalty", "ball stuck in the area", Gain::kOther, kStood},
    Clause{kPush, "Free kick", "pushing", Gain::kOther, kPressed},
    Clause{kFreeKickHolding, "Free kick", "ball held", Gain::kOther, kStood},
    Clause{"half", "Half-time", ""},
    Clause{"full-time", "Full time", "", Gain::kNamed, kLead},
    Clause{"overtime", "Overtime", "", Gain::kNobody, {"part ", ""}},
    Clause{"shoot-out", "Shoot-out", "", Gain::kNamed},
    Clause{"false-start", "False start", "", Gain::kNobody, kMoved},
    Clause{kMercy, "Full time", "the lead is too large", Gain::kNamed, kLead},
    Clause{"walk-over", "Walk-over", "a team is absent or failed", Gain::kOther},
    Clause{"team.failed", "Team failed", "it starts again", Gain::kNobody, {"failure ", ""}},
    Clause{"match.abandoned", "Match abandoned", ""},
    Clause{"placement", "", "", Gain::kNobody, kMoved},
};

/// The words for a call; null for an unknown name.
constexpr const Clause* find(std::string_view name) {
  for (const Clause& clause : kClauses) {
    if (clause.name == name) return &clause;
  }
  return nullptr;
}

}  // namespace fulbito::clause
