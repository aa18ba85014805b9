#include "match/check/team_check.hpp"

#include <algorithm>

#include "engine/core/system/machine_room.hpp"
#include "match/check/plays.hpp"
#include "match/check/repeats.hpp"
#include "match/check/situations.hpp"
#include "match/check/verdicts.hpp"
#include "match/drills/drill.hpp"

namespace fulbito {
namespace {

// Drills of skills that every team needs: an empty goal, a keeper's save, the clearing of a jam, a penalty.
const std::vector<int> kDrills{3, 10, 13, 16};
constexpr int kTrials = 20;
const std::vector<int> kQuickDrills{3, 10};
constexpr int kQuickTrials = 6;
// In a quick check, only one situation in three is repeated: each starts the team four times.
constexpr std::size_t kQuickEvery = 3;

/// One run of the whole check.
class Run {
 public:
  explicit Run(const TeamCheckOptions& options) : options_(options) {}

  Result<TeamReport> report() {
    for (const auto& step : {&Run::prepare, &Run::play, &Run::repeat, &Run::drill}) {
      if (auto done = (this->*step)(); !done) return tl::unexpected<Error>(done.error());
    }
    return TeamReport{options_.team.text, origin(), options_.seed, options_.quick, checks()};
  }

 private:
  Result<void> prepare() {
    for (const TeamId seat : kTeams) {
      auto situations = checkSituations(seat, options_.seed, options_.quick);
      if (!situations) return tl::unexpected<Error>(situations.error());
      seats_[indexOf(seat)] = std::move(*situations);
    }
    plays_.limit = *seats_[0].front().match.decision_time;
    total_ = 3 * seats_[0].size() + drills().size();
    return {};
  }

  Result<void> play() {
    for (const auto& situations : seats_) {
      for (const CheckSituation& situation : situations) {
        auto played =
            room_.run([&] { return playSituation(situation, options_.team, options_.clock, plays_); });
        if (played) played = advance();
        if (!played) return played;
      }
    }
    return {};
  }

  // The calls are recorded in one seat; the comparison of seats also tells them in the other.
  Result<void> repeat() {
    for (std::size_t i = 0; i < seats_[0].size(); ++i) {
      Result<void> repeated;
      if (!options_.quick || i % kQuickEvery == 0) {
        repeated = room_.run([&] { return repeatSituation(seats_[0][i], options_.team, repeats_); });
      }
      if (repeated) repeated = advance();
      if (!repeated) return repeated;
    }
    return {};
  }

  Result<void> drill() {
    // drills have no time limit: a team that hangs would block one for ever
    if (plays_.broken > 0) return {};
    DrillOptions options;
    options.team = options_.team;
    options.catalogue = options_.catalogue;
    options.trials = options_.quick ? kQuickTrials : kTrials;
    options.seed = options_.seed;
    options.jobs = options_.jobs;
    const std::size_t before = done_;
    auto reports = runDrills(builtInDrills(), drills(), options, [&](std::size_t done, std::size_t total) {
      done_ = before + drills().size() * done / std::max<std::size_t>(1, total);
      return !options_.progress || options_.progress(done_, total_);
    });
    if (!reports) return tl::unexpected<Error>(reports.error());
    drills_ = std::move(*reports);
    return {};
  }

  Result<void> advance() {
    ++done_;
    if (!options_.progress || options_.progress(done_, total_)) return {};
    return fail(ErrorCode::kInterrupted, "interrupted");
  }

  const std::vector<int>& drills() const { return options_.quick ? kQuickDrills : kDrills; }

  std::vector<Setting> origin() const {
    std::vector<Setting> all = options_.team.origin;
    all.insert(all.end(), plays_.notes.origin.begin(), plays_.notes.origin.end());
    return all;
  }

  std::vector<TeamCheck> checks() const {
    std::vector<TeamCheck> checks{
        startVerdict(plays_),     protocolVerdict(plays_),
        valuesVerdict(plays_),    motorsVerdict(plays_),
        timeVerdict(plays_),      determinismVerdict(repeats_),
        seatVerdict(repeats_),    mirrorVerdict(repeats_),
        placementVerdict(plays_), drawingsVerdict(plays_),
        rolesVerdict(plays_),     containmentVerdict(plays_, options_.team.info->outside)};
    if (!drills_.empty()) checks.push_back(drillsVerdict(drills_));
    return checks;
  }

  const TeamCheckOptions& options_;
  MachineRoom room_;
  PerTeam<std::vector<CheckSituation>> seats_;
  PlayFindings plays_;
  AllRepeats repeats_;
  std::vector<DrillReport> drills_;
  std::size_t done_ = 0;
  std::size_t total_ = 0;
};

}  // namespace

const char* nameOf(CheckVerdict verdict) {
  constexpr const char* kNames[] = {"ok", "warning", "failed"};
  return kNames[static_cast<std::size_t>(verdict)];
}

CheckVerdict TeamReport::verdict() const {
  CheckVerdict worst = CheckVerdict::kOk;
  for (const TeamCheck& check : checks) worst = std::max(worst, check.verdict);
  return worst;
}

Result<TeamReport> checkTeam(const TeamCheckOptions& options) { return Run(options).report(); }

}  // namespace fulbito
