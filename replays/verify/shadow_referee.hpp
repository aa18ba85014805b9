#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fulbito/detail/values.hpp"
#include "fulbito/recording.hpp"
#include "fulbito/referee.hpp"

/// Shadow referees: two rules profiles judge the same recorded plays. Each play is judged from its recorded
/// start, clock and score up to the tick at which the recording's own referee stopped it. What happens after
/// that tick is unknown.
namespace fulbito {

/// The first call by which a referee stopped a play.
struct ShadowVerdict {
  Tick tick = 0;       ///< tick of the recording
  std::string clause;  ///< the rule, see `GameEvent`
  std::optional<TeamId> team;
  RestartKind restart = RestartKind::kKickOff;  ///< the restart that would follow
  TeamId restart_team = TeamId::kBlue;
  double value = 0.0;  ///< measured value, see `GameEvent`
  double threshold = 0.0;
};

/// Agreement of two verdicts on a play.
enum class VerdictAgreement : std::uint8_t {
  kNone,       ///< neither stopped it
  kSame,       ///< the same call at the same tick
  kAEarlier,   ///< the same call, A's first
  kBEarlier,   ///< the same call, B's first
  kOnlyA,      ///< B had not called when the play ended
  kOnlyB,      ///< A had not called when the play ended
  kDifferent,  ///< different rule, team or restart
};

/// Both verdicts on one play.
struct PlayVerdicts {
  std::size_t file = 0;   ///< index of the recording, from 0
  std::int64_t play = 0;  ///< number of the play, from 0
  Tick begin = 0, end = 0;
  std::optional<ShadowVerdict> a, b;
  VerdictAgreement agreement = VerdictAgreement::kNone;
  double lead = 0.0;  ///< [s] lead of the first call over the other
};

/// Statistics of the plays in which at least one profile called a rule.
struct RuleAgreement {
  std::string clause;
  std::int64_t a = 0, b = 0;  ///< plays that each profile stopped for this rule
  std::int64_t same = 0, a_earlier = 0, b_earlier = 0, only_a = 0, only_b = 0;
  std::int64_t different = 0;         ///< plays in which the other profile made a different call
  double a_lead = 0.0, b_lead = 0.0;  ///< mean lead where one profile was earlier [s]
};

/// Two different calls on the same play, and their number.
struct VerdictPair {
  std::string a, b;  ///< clauses, with the restart if only that differs
  std::int64_t count = 0;
};

/// The result of a comparison.
struct RulesComparison {
  std::string a, b;  ///< names of the profiles
  std::size_t files = 0;
  Tick ticks = 0;
  double seconds = 0.0;  ///< simulated time [s]
  std::vector<PlayVerdicts> plays;
  /// @{ Number of plays whose recorded end the profile called too. For the profile of the recording, these
  /// are all plays.
  std::int64_t recorded_a = 0, recorded_b = 0;
  /// @}
};

/// Judges one more recording with both profiles. Length of halves and team size come from the recording, so
/// only calls are compared; shoot-outs are skipped. Errors: kBadInput if it is not a match or cannot be
/// simulated.
Result<void> compareRules(const RecordingReader& recording, const Rules& a, const Rules& b,
                          RulesComparison& comparison);

/// Statistics by rule, sorted by clause.
std::vector<RuleAgreement> byRule(const RulesComparison& comparison);
/// The pairs of different calls, most frequent first.
std::vector<VerdictPair> differentPairs(const RulesComparison& comparison);
/// The number of plays with this agreement.
std::int64_t countOf(const RulesComparison& comparison, VerdictAgreement agreement);

}  // namespace fulbito
