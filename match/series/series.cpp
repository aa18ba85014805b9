#include <algorithm>
#include <mutex>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"
#include "engine/core/system/worker_threads.hpp"
#include "fulbito/match.hpp"
#include "fulbito/statistics.hpp"
#include "match/series/foul_goals.hpp"

namespace fulbito {
namespace {

constexpr int kMaxPairs = 100000;
constexpr int kMaxJobs = 1024;
constexpr Tick kTicksBetweenLooks = 4096;  // about a minute of play

/// The pairs of a series while several threads play them.
class Schedule {
 public:
  Schedule(const SeriesConfig& config, const SeriesProgress& watcher)
      : config_(config),
        pairs_(static_cast<std::size_t>(config.pairs)),
        progress_(watcher, pairs_.size() * 2),
        legs_done_(pairs_.size() * 2, 0) {
    for (std::size_t i = 0; i < pairs_.size(); ++i) pairs_[i].seed = seedOfPair(config.match.seed, i);
  }

  /// Plays the legs. Errors: of a match; kInterrupted when stopped.
  Result<void> play();
  /// Of what was played.
  SeriesResult result();

 private:
  MatchConfig configOf(std::size_t leg) const;
  Result<void> playLeg(std::size_t leg);
  bool goesOn();
  void finish(std::size_t leg, const LegRecord& record);
  bool complete(std::size_t pair) const { return legs_done_[2 * pair] != 0 && legs_done_[2 * pair + 1] != 0; }

  const SeriesConfig& config_;
  std::vector<PairRecord> pairs_;
  WorkProgress progress_;
  std::mutex judging_;  // of all below
  std::vector<char> legs_done_;
  std::size_t judged_ = 0;  // pairs that the judge has heard of
  bool ended_ = false;      // by the judge
};

MatchConfig Schedule::configOf(std::size_t leg) const {
  MatchConfig config = config_.match;
  config.seed = pairs_[leg / 2].seed;
  if (leg % 2 == 1) {
    std::swap(config.teams[0], config.teams[1]);
    std::swap(config.vision[0], config.vision[1]);  // it belongs to the team
  }
  return config;
}

Result<void> Schedule::play() {
  return parallelFor(config_.jobs, pairs_.size() * 2, progress_,
                     [this](std::size_t leg) { return playLeg(leg); });
}

Result<void> Schedule::playLeg(std::size_t leg) {
  auto match = Match::create(configOf(leg), config_.clock);
  if (!match) return tl::unexpected<Error>(match.error());
  FoulGoalCounter fouls;
  match->watch(fouls);
  while (match->step()) {
    if (match->tick() % kTicksBetweenLooks == 0 && !goesOn()) {
      return fail(ErrorCode::kInterrupted, "interrupted");
    }
  }
  finish(leg, {match->referee().score, fouls.goals(), match->tick(), match->hash(), match->faults()});
  return goesOn() ? Result<void>() : fail(ErrorCode::kInterrupted, "interrupted");
}

bool Schedule::goesOn() {
  {
    const std::lock_guard lock(judging_);
    if (ended_) return false;
  }
  return progress_.goesOn();
}

// A pair that is complete early waits for those before it: the judge's verdict must not depend on who is
// fast.
void Schedule::finish(std::size_t leg, const LegRecord& record) {
  const std::lock_guard lock(judging_);
  pairs_[leg / 2].legs[leg % 2] = record;
  legs_done_[leg] = 1;
  while (config_.judge && !ended_ && judged_ < pairs_.size() && complete(judged_)) {
    ended_ = !config_.judge(pairs_[judged_]);
    ++judged_;
  }
}

void count(SeriesResult& result) {
  std::vector<double> points, differences;
  for (const PairRecord& pair : result.pairs) {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      const int mine = pair.legs[leg].score[leg], theirs = pair.legs[leg].score[1 - leg];
      result.wins += mine > theirs ? 1 : 0;
      result.draws += mine == theirs ? 1 : 0;
      result.losses += mine < theirs ? 1 : 0;
      result.goals_after_foul_for += pair.legs[leg].goals_after_foul[leg];
      result.goals_after_foul_against += pair.legs[leg].goals_after_foul[1 - leg];
    }
    result.goals_for += pair.goalsOfA();
    result.goals_against += pair.goalsOfB();
    points.push_back(pair.points());
    differences.push_back((pair.goalsOfA() - pair.goalsOfB()) / 2.0);
  }
  result.points_share = shareInterval(points);
  result.goal_difference = meanInterval(differences);
}

SeriesResult Schedule::result() {
  SeriesResult result;
  const auto missing = std::find(legs_done_.begin(), legs_done_.end(), 0);
  const auto played = static_cast<std::size_t>(missing - legs_done_.begin()) / 2;
  result.interrupted = !ended_ && played < pairs_.size();
  pairs_.resize(ended_ ? judged_ : played);
  result.pairs = std::move(pairs_);
  count(result);
  return result;
}

Result<void> checkRanges(const SeriesConfig& config) {
  if (config.pairs < 1 || config.pairs > kMaxPairs) {
    return fail(ErrorCode::kUsage, fmt::format("pairs: {} is outside 1 ... {}", config.pairs, kMaxPairs));
  }
  if (config.jobs < 0 || config.jobs > kMaxJobs) {
    return fail(ErrorCode::kUsage, fmt::format("jobs: {} is outside 0 ... {}", config.jobs, kMaxJobs));
  }
  return {};
}

}  // namespace

double PairRecord::points() const {
  double sum = 0.0;
  for (std::size_t leg = 0; leg < 2; ++leg) {
    const int mine = legs[leg].score[leg], theirs = legs[leg].score[1 - leg];
    sum += mine > theirs ? 0.5 : (mine == theirs ? 0.25 : 0.0);
  }
  return sum;
}

std::uint64_t seedOfPair(std::uint64_t series_seed, std::uint64_t pair) {
  if (pair == 0) return series_seed;
  return Rng(series_seed, Stream::kSeries, pair).bits64() >> 11;  // exact as a number in JSON
}

Result<SeriesResult> playSeries(const SeriesConfig& config, const SeriesProgress& progress) {
  if (auto checked = checkRanges(config); !checked) return tl::unexpected<Error>(checked.error());
  Schedule schedule(config, progress);
  const auto played = schedule.play();
  if (!played && played.error().code != ErrorCode::kInterrupted) return tl::unexpected<Error>(played.error());
  return schedule.result();
}

}  // namespace fulbito
