#include "match/check/repeats.hpp"

#include <fmt/format.h>

namespace fulbito {
namespace {

/// The calls to the seat while a built-in team plays the situation. They never depend on the team under test.
Result<RecordedCalls> callsOf(const CheckSituation& situation) {
  RecordedCalls kept;
  MatchConfig config = situation.match;
  const DecisionTime limit = *config.decision_time;
  config.decision_time.reset();  // no clock: the recorded calls are always the same
  TeamChoice& choice = config.teams[indexOf(situation.seat)];
  choice = overheardTeam(choice, kept);
  auto match = Match::create(config);
  if (!match) return tl::unexpected<Error>(match.error());
  while (match->tick() < situation.ticks && match->step()) {
  }
  kept.info.decision_time = limit;
  return kept;
}

void add(const AnswerDifference& found, const TeamAnswers& other, const std::string& place,
         RepeatFindings& findings) {
  findings.compared += found.compared;
  if (findings.different == 0 && found.different > 0) {
    findings.first = found.robot < 0
                         ? fmt::format("a placement in '{}'", place)
                         : fmt::format("robot {}, decision {} of '{}'", found.robot, found.first, place);
  }
  findings.different += found.different;
  if (findings.failure.empty()) findings.failure = other.failure;
}

}  // namespace

Result<void> repeatSituation(const CheckSituation& situation, const TeamChoice& team, AllRepeats& findings) {
  if (!findings.again.failure.empty()) return {};  // each new start would take its time to fail again
  const auto told = callsOf(situation);
  if (!told) return tl::unexpected<Error>(told.error());
  const auto first = answersOf(team, *told);
  if (!first) return tl::unexpected<Error>(first.error());
  const auto again = answersOf(team, *told);
  if (!again) return tl::unexpected<Error>(again.error());
  const auto seat = answersOf(team, inOtherSeat(*told));
  if (!seat) return tl::unexpected<Error>(seat.error());
  const RecordedCalls sided = offAxis(*told);
  const auto mirror = answersOf(team, mirrored(sided));
  if (!mirror) return tl::unexpected<Error>(mirror.error());
  findings.again.failure = first->failure;
  add(compareAnswers(*told, *first, *again), *again, situation.name, findings.again);
  add(compareAnswers(*told, *first, *seat), *seat, situation.name, findings.seat);
  add(compareMirrored(sided, *first, *mirror), *mirror, situation.name, findings.mirror);
  return {};
}

}  // namespace fulbito
