#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/match.hpp"
#include "tournament/results/play_record.hpp"

namespace fulbito {

/// How a match ended, from good to bad. Every outcome counts by its score. A match that the machine failed
/// has no result, so it has no outcome here.
enum class MatchOutcome : std::uint8_t {
  kNormal,   ///< played to its end, no team at fault
  kMercy,    ///< ended early because a team had the lead that the rules name
  kSlow,     ///< a team took too long for some decisions
  kIllegal,  ///< a team sent commands that are not numbers, or for navigators that it does not have
  kCrash,    ///< a team outside the program failed at least once, but played on
  kForfeit   ///< a walk-over: a team was absent or failed too often
};
/// "normal", "mercy", "slow", "illegal", "crash", "forfeit".
std::string_view nameOf(MatchOutcome outcome);
/// The outcome with this name, if any.
std::optional<MatchOutcome> outcomeOf(std::string_view name);

/// The identity of a match: the hash of everything that determines it (tournament/identity).
struct MatchId {
  std::array<std::uint64_t, 2> words{};
  /// 32 hexadecimal digits.
  std::string text() const;
  /// Parses the result of `text`; empty for any other text.
  static std::optional<MatchId> parse(std::string_view text);
  friend auto operator<=>(const MatchId&, const MatchId&) = default;
};

/// The result of one match. Two runs of the same match have equal results.
struct MatchResult {
  PerTeam<int> score{};             ///< goals of blue and yellow
  std::optional<TeamId> winner;     ///< winner, also by a shoot-out; empty for a draw
  PerTeam<int> goals_after_foul{};  ///< goals within `kFoulPaysWithin` after a foul of the scoring team
  PlayRecord play;                  ///< how both teams played
  Tick ticks = 0;                   ///< length of the match [ticks]
  std::uint64_t hash = 0;           ///< `Match::hash` at the end
  MatchOutcome outcome = MatchOutcome::kNormal;
  MatchFaults faults;  ///< faults of both teams
};

/// Two matches with the same start and seed, the statistical unit. A plays blue in the first and yellow in
/// the second.
struct PairResult {
  std::uint64_t seed = 0;  ///< seed of both matches
  std::array<MatchResult, 2> legs;

  /// Goals of A in both matches.
  int goalsOfA() const { return legs[0].score[0] + legs[1].score[1]; }
  /// Goals of B in both matches.
  int goalsOfB() const { return legs[0].score[1] + legs[1].score[0]; }
  /// A's share of the points of leg 0 or 1: 1 for a win, 1/2 for a draw.
  double pointsOfLeg(std::size_t leg) const;
  /// Points share of A over both matches, 0 ... 1; a draw counts half.
  double points() const { return (pointsOfLeg(0) + pointsOfLeg(1)) / 2; }
};

/// A line of a tournament's log: a match and its result. It can be read without the plan.
struct MatchRow {
  MatchId id;
  PerTeam<std::string> teams;  ///< names of blue and yellow
  std::string start;           ///< name of the start, such as "kick-off" or "free-ball:17"
  std::uint64_t seed = 0;
  MatchResult result;
};

}  // namespace fulbito
