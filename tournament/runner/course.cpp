#include "tournament/runner/course.hpp"

#include <utility>

namespace fulbito {

Course::Course(const TournamentPlan& plan) : plan_(plan) {
  if (plan.sprt) sprt_.emplace(*plan.sprt);
  extend();
}

bool Course::extend() {
  if (schedule_.complete) return false;
  const std::size_t before = results_.size();
  schedule_ = scheduleOf(plan_, results_);
  results_.resize(schedule_.fixtures.size());
  return results_.size() > before;
}

const MatchResult* Course::result(std::size_t fixture, std::size_t leg) const {
  if (results_[fixture]) return &results_[fixture]->legs[leg];
  const auto half = halves_.find(fixture);
  return half != halves_.end() && half->second[leg] ? &*half->second[leg] : nullptr;
}

void Course::take(std::size_t fixture, std::size_t leg, MatchResult result) {
  if (results_[fixture]) return;
  auto& legs = halves_[fixture];
  if (!legs[leg]) legs[leg] = std::move(result);
  if (!legs[0] || !legs[1]) return;
  const std::uint64_t seed = seedOfStart(plan_.seed, schedule_.fixtures[fixture].start);
  results_[fixture] = PairResult{seed, {std::move(*legs[0]), std::move(*legs[1])}};
  halves_.erase(fixture);
  judge();
}

void Course::judge() {
  while (sprt_ && !decided() && judged_ < results_.size() && results_[judged_]) {
    sprt_->add(results_[judged_]->points());
    ++judged_;
  }
}

// Which matches were played after the verdict of a test depends on timing, so their results are left out.
TournamentState Course::state() && {
  for (std::size_t i = judged_; decided() && i < results_.size(); ++i) results_[i].reset();
  TournamentState state{plan_, std::move(schedule_), std::move(results_), {}, sprt_, 0, {}};
  state.counted = sprt_ ? judged_ : state.results.size();
  return state;
}

std::size_t failedMatches(const TournamentState& state) {
  std::size_t failed = 0;
  for (std::size_t i = 0; i < state.counted; ++i) {
    if (!state.results[i]) continue;
    for (const MatchResult& leg : state.results[i]->legs) {
      failed += leg.outcome >= MatchOutcome::kCrash ? 1 : 0;
    }
  }
  return failed;
}

bool TournamentState::finished() const {
  if (sprt && sprt->verdict() != SprtVerdict::kInconclusive) return true;
  if (!schedule.complete) return false;
  for (const auto& result : results) {
    if (!result) return false;
  }
  return true;
}

}  // namespace fulbito
