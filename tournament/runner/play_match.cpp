#include "tournament/runner/play_match.hpp"

#include <algorithm>
#include <optional>

#include "engine/core/system/stop_request.hpp"
#include "fulbito/statistics.hpp"
#include "referee/rules/clauses.hpp"

namespace fulbito {
namespace {

constexpr Tick kTicksBetweenLooks = 4096;  // about a minute of play
constexpr Tick kTicksPerTurn = 64;         // large enough that changes of turns cost little

/// Watches whether the lead that the rules name ended the match.
class MercyWatch final : public MatchObserver {
 public:
  bool heard() const { return heard_; }
  void onTick(const MatchTick& tick) override {
    for (const GameEvent& event : tick.events) heard_ = heard_ || event.clause == clause::kMercy;
  }

 private:
  bool heard_ = false;
};

bool anyFault(const MatchFaults& faults, bool (*has)(const TeamFaults&)) {
  return std::any_of(faults.teams.begin(), faults.teams.end(), has);
}

}  // namespace

bool hasOutsideTeam(const MatchConfig& config) {
  return config.teams[0].info->outside || config.teams[1].info->outside;
}

MatchOutcome outcomeOf(const MatchFaults& faults, bool walk_over, bool mercy) {
  if (walk_over || anyFault(faults, [](const TeamFaults& f) { return f.forfeited; })) {
    return MatchOutcome::kForfeit;
  }
  if (anyFault(faults, [](const TeamFaults& f) { return f.failures > 0; })) return MatchOutcome::kCrash;
  if (anyFault(faults, [](const TeamFaults& f) { return f.not_finite + f.no_navigator > 0; })) {
    return MatchOutcome::kIllegal;
  }
  if (anyFault(faults, [](const TeamFaults& f) { return f.late > 0; })) return MatchOutcome::kSlow;
  return mercy ? MatchOutcome::kMercy : MatchOutcome::kNormal;
}

Result<MatchResult> playMatch(const MatchConfig& config, const MatchClock& clock,
                              const std::function<bool()>& goes_on, MatchObserver* observer, Turns* turns) {
  // Begins before the teams start, because their start also has a time limit.
  std::optional<Turn> turn;
  if (turns != nullptr) turn.emplace(*turns);
  auto match = Match::create(config, clock);
  if (!match) return tl::unexpected<Error>(match.error());
  StatisticsObserver watcher;
  MercyWatch mercy;
  match->watch(watcher);
  match->watch(mercy);
  if (observer != nullptr) match->watch(*observer);
  while (match->step()) {
    if (match->tick() % kTicksBetweenLooks == 0 && !goes_on()) {
      return fail(ErrorCode::kInterrupted, "interrupted");
    }
    if (turn && match->tick() % kTicksPerTurn == 0) {
      turn.reset();  // gives the turn back first, so that another match may take it
      turn.emplace(*turns);
    }
  }
  MatchFaults faults = match->faults();
  if (faults.abandoned) {
    return fail(faults.abandoned->code, "the match was abandoned: " + faults.abandoned->message);
  }
  // After a stop request, waits for outside teams end early and look like late decisions, so the result does
  // not count.
  if (hasOutsideTeam(config) && stopRequested()) return fail(ErrorCode::kInterrupted, "interrupted");
  const bool absent = !config.present[0] || !config.present[1];
  const MatchOutcome outcome = outcomeOf(faults, absent, mercy.heard());
  const RefereeState& referee = match->referee();
  const MatchStatistics& counted = watcher.statistics();
  return MatchResult{referee.score,
                     referee.winner,
                     {counted.teams[0].goals_after_foul, counted.teams[1].goals_after_foul},
                     recordOf(counted),
                     match->tick(),
                     match->hash(),
                     outcome,
                     std::move(faults)};
}

}  // namespace fulbito
