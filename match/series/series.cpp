#include <algorithm>

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
        legs_done_(pairs_.size() * 2, 0),
        progress_(watcher, legs_done_.size()) {
    for (std::size_t i = 0; i < pairs_.size(); ++i) pairs_[i].seed = seedOfPair(config.match.seed, i);
  }

  /// Plays the legs. Errors: of a match; kInterrupted when stopped.
  Result<void> play();
  /// Of what was played.
  SeriesResult result();

 private:
  MatchConfig configOf(std::size_t leg) const;
  Result<void> playLeg(std::size_t leg);

  const SeriesConfig& config_;
  std::vector<PairRecord> pairs_;
  std::vector<char> legs_done_;
  WorkProgress progress_;
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
  return parallelFor(config_.jobs, legs_done_.size(), progress_,
                     [this](std::size_t leg) { return playLeg(leg); });
}

Result<void> Schedule::playLeg(std::size_t leg) {
  auto match = Match::create(configOf(leg), config_.clock);
  if (!match) return tl::unexpected<Error>(match.error());
  FoulGoalCounter fouls;
  match->watch(fouls);
  while (match->step()) {
    if (match->tick() % kTicksBetweenLooks == 0 && !progress_.goesOn()) {
      return fail(ErrorCode::kInterrupted, "interrupted");
    }
  }
  pairs_[leg / 2].legs[leg % 2] = {match->referee().score, fouls.goals(), match->tick(), match->hash(),
                                   match->faults()};
  legs_done_[leg] = 1;
  return {};
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
  const auto complete = static_cast<std::size_t>(missing - legs_done_.begin()) / 2;
  result.interrupted = complete < pairs_.size();
  pairs_.resize(complete);
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
