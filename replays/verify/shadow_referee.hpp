#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/base/restart_kind.hpp"
#include "referee/rules/rules.hpp"
#include "replays/recording_reader.hpp"

/// Shadow referees: two profiles of rules judge the same recorded plays. Each play is judged from its
/// recorded start, clock and score, up to where the recording's own referee stopped it; what a referee would
/// have called after that is not known.
namespace fulbito {

/// What one referee first stopped a play for.
struct ShadowVerdict {
  Tick tick = 0;       ///< of the recording
  std::string clause;  ///< the rule, see GameEvent
  std::optional<TeamId> team;
  RestartKind restart = RestartKind::kKickOff;  ///< how play would go on
  TeamId restart_team = TeamId::kBlue;
  double value = 0.0;  ///< what was measured, see GameEvent
  double threshold = 0.0;
};

/// How two verdicts on a play agree.
enum class VerdictAgreement : std::uint8_t {
  kNone,       ///< neither stopped it
  kSame,       ///< the same call at the same tick
  kAEarlier,   ///< the same call, A's first
  kBEarlier,   ///< the same call, B's first
  kOnlyA,      ///< B had not called when the play ended
  kOnlyB,      ///< A had not called when the play ended
  kDifferent,  ///< another rule, team or restart
};

/// Both verdicts on one play.
struct PlayVerdicts {
  std::size_t file = 0;   ///< which recording, from 0
  std::int64_t play = 0;  ///< from 0
  Tick begin = 0, end = 0;
  std::optional<ShadowVerdict> a, b;
  VerdictAgreement agreement = VerdictAgreement::kNone;
  double lead = 0.0;  ///< [s] by which the first of two calls came before the other
};

/// All plays in which one of the two called a rule.
struct RuleAgreement {
  std::string clause;
  std::int64_t a = 0, b = 0;  ///< plays that each stopped for it
  std::int64_t same = 0, a_earlier = 0, b_earlier = 0, only_a = 0, only_b = 0;
  std::int64_t different = 0;         ///< where the other called something else
  double a_lead = 0.0, b_lead = 0.0;  ///< [s] mean, where one was earlier
};

/// Two different calls, and how often they met.
struct VerdictPair {
  std::string a, b;  ///< clauses, with the restart where that alone differs
  std::int64_t count = 0;
};

/// What came of a comparison.
struct RulesComparison {
  std::string a, b;  ///< names of the profiles
  std::size_t files = 0;
  Tick ticks = 0;
  double seconds = 0.0;  ///< simulated
  std::vector<PlayVerdicts> plays;
  /// @{ Plays whose recorded end the profile called too: all of them for the profile that they were played
  /// by.
  std::int64_t recorded_a = 0, recorded_b = 0;
  /// @}
};

/// Lets both profiles judge one more recording. The length of halves and the team size are taken from the
/// recording, so that only calls are compared; plays of a shoot-out are left out. Errors: kBadInput for a
/// recording that is no match or cannot be played again.
Result<void> compareRules(const RecordingReader& recording, const Rules& a, const Rules& b,
                          RulesComparison& comparison);

/// By rule, in the order of the clauses' names.
std::vector<RuleAgreement> byRule(const RulesComparison& comparison);
/// The calls that differ, the most frequent first.
std::vector<VerdictPair> differentPairs(const RulesComparison& comparison);
/// Plays of one kind.
std::int64_t countOf(const RulesComparison& comparison, VerdictAgreement agreement);

}  // namespace fulbito
