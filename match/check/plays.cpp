#include "match/check/plays.hpp"

#include <fmt/format.h>

namespace fulbito {
namespace {

// After this many broken situations the rest are skipped: a team that hangs would use its whole time in each.
constexpr int kMostBroken = 3;

/// Counts how a match treats one team's commands and places.
class SeatCount final : public MatchObserver {
 public:
  explicit SeatCount(const CheckSituation& situation)
      : team_(situation.seat), hold_(situation.match.rules.restart.hold_robots) {}

  void onPlayStart(const PlayStart& start) override {
    playing_ = start.referee->playing;
    countRepairs(start.events);
  }
  void onTick(const MatchTick& tick) override {
    const bool held = hold_ && !playing_;
    playing_ = tick.referee->playing;
    if (held) return;
    for (const RobotId& id : tick.ids) commands_ += id.team == team_ ? 1 : 0;
  }
  std::int64_t commands() const { return commands_; }
  std::int64_t repaired() const { return repaired_; }

 private:
  void countRepairs(std::span<const GameEvent> events) {
    for (const GameEvent& event : events) {
      repaired_ += event.clause == "placement" && event.team == team_ ? 1 : 0;
    }
  }

  TeamId team_;
  bool hold_;
  bool playing_ = false;  ///< play was running before the tick
  std::int64_t commands_ = 0;
  std::int64_t repaired_ = 0;
};

std::string placeOf(const CheckSituation& situation) {
  return fmt::format("{} (as {})", situation.name, nameOf(situation.seat));
}

void addFaults(const TeamFaults& faults, const std::string& place, PlayFindings& findings) {
  findings.failures.add(faults.failures, place);
  findings.stale.add(faults.stale, place);
  findings.not_finite.add(faults.not_finite, place);
  findings.no_navigator.add(faults.no_navigator, place);
  findings.saturated.add(faults.saturated, place);
  findings.late.add(faults.late, place);
  if (findings.reason.empty()) findings.reason = faults.failure;
  findings.forfeited = findings.forfeited || faults.forfeited;
}

}  // namespace

void FoundIn::add(std::int64_t more, const std::string& situation) {
  if (count == 0 && more > 0) first = situation;
  count += more;
}

Result<void> playSituation(const CheckSituation& situation, const TeamChoice& team, const MatchClock& clock,
                           PlayFindings& findings) {
  if (findings.broken >= kMostBroken) {
    ++findings.skipped;
    return {};
  }
  MatchConfig config = situation.match;
  config.teams[indexOf(situation.seat)] = watchedTeam(team, clock, findings.notes);
  auto match = Match::create(config, clock);
  if (!match) return tl::unexpected<Error>(match.error());
  SeatCount count(situation);
  match->watch(count);
  const auto faults = [&] { return match->faults().teams[indexOf(situation.seat)]; };
  const std::int64_t most_late = findings.limit.held;
  bool broken = false;
  while (match->tick() < situation.ticks && !broken && match->step()) {
    broken = faults().late > most_late || faults().forfeited;
  }
  if (const auto abandoned = match->faults().abandoned) return tl::unexpected<Error>(*abandoned);
  match->finish();
  broken = broken || faults().forfeited;
  findings.broken += broken ? 1 : 0;
  ++findings.situations;
  const std::string place = placeOf(situation);
  addFaults(faults(), place, findings);
  findings.repaired.add(count.repaired(), place);
  findings.commands += count.commands();
  return {};
}

}  // namespace fulbito
