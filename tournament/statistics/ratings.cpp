#include "tournament/statistics/ratings.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "tournament/statistics/gamma.hpp"
#include "tournament/statistics/resampled_ratings.hpp"
#include "tournament/statistics/win_graph.hpp"

namespace fulbito {
namespace {

constexpr double kLeastShape = 0.5;

using EntrantPair = std::pair<std::size_t, std::size_t>;

void addMatches(WeightedMeeting& meeting, double weight, const PairMatches& matches) {
  meeting.wins += weight * matches.wins;
  meeting.draws += weight * matches.draws;
  meeting.losses += weight * matches.losses;
}

/// The same pairs from the view of B.
PairOutcomes turned(const PairOutcomes& pairs) {
  PairOutcomes other;
  constexpr std::array<PairOutcome, kPairOutcomes> kTurned{PairOutcome::kWW, PairOutcome::kWD,
                                                           PairOutcome::kDD, PairOutcome::kWL,
                                                           PairOutcome::kLD, PairOutcome::kLL};
  for (std::size_t i = 0; i < kPairOutcomes; ++i) {
    other.counts[static_cast<std::size_t>(kTurned[i])] = pairs.counts[i];
  }
  return other;
}

/// The meetings with all pairs of each two entrants joined, in order of the entrants.
std::map<EntrantPair, PairOutcomes> joined(std::span<const MeetingCounts> meetings) {
  std::map<EntrantPair, PairOutcomes> joined;
  for (const MeetingCounts& meeting : meetings) {
    if (meeting.a == meeting.b || meeting.pairs.pairs() == 0) continue;
    const PairOutcomes pairs = meeting.a < meeting.b ? meeting.pairs : turned(meeting.pairs);
    auto& sum = joined[std::minmax(meeting.a, meeting.b)].counts;
    for (std::size_t i = 0; i < kPairOutcomes; ++i) sum[i] += pairs.counts[i];
  }
  return joined;
}

/// Shape of the gamma distribution of a weight, if `units` results determine `unknowns` ratings. Exp(1),
/// which has shape 1, would make intervals too narrow, because the ratings are fitted to the same results.
/// This shape raises the variance as for residuals; for two entrants it becomes that of the mean score.
double shapeOf(double units, double unknowns) {
  return std::max(kLeastShape, (units - unknowns) / std::max(1.0, units));
}

/// `shapeOf` for the pairs of each meeting, from the numbers of pairs and entrants of its component.
std::vector<double> shapesOf(std::size_t entrants, const WeightedMeetings& observed,
                             const std::vector<PairOutcomes>& pairs) {
  const std::vector<int> component = winGraph(entrants, observed).component;
  std::vector<double> unknowns(entrants, -1.0), count(entrants, 0.0), shapes;
  for (const int group : component) unknowns[static_cast<std::size_t>(group)] += 1.0;
  const auto group = [&](std::size_t m) { return static_cast<std::size_t>(component[observed[m].a]); };
  for (std::size_t m = 0; m < pairs.size(); ++m) count[group(m)] += static_cast<double>(pairs[m].pairs());
  for (std::size_t m = 0; m < pairs.size(); ++m)
    shapes.push_back(shapeOf(count[group(m)], unknowns[group(m)]));
  return shapes;
}

/// A result of a unit, and the index of its meeting.
struct PlacedResult {
  std::size_t unit, meeting;
  PairMatches match;
};

PairMatches matchOf(double points) {
  return {points > 0.75 ? 1 : 0, points > 0.25 && points <= 0.75 ? 1 : 0, points <= 0.25 ? 1 : 0};
}

/// Fills `meetings` in order of their entrants, and returns each result with the index of its meeting.
std::vector<PlacedResult> placed(std::span<const UnitResult> results, WeightedMeetings& meetings) {
  std::map<EntrantPair, std::size_t> numbers;
  for (const UnitResult& result : results) numbers[std::minmax(result.a, result.b)];
  for (auto& [entrants, number] : numbers) {
    number = meetings.size();
    meetings.push_back({entrants.first, entrants.second, 0.0, 0.0, 0.0});
  }
  std::vector<PlacedResult> placed;
  for (const UnitResult& result : results) {
    placed.push_back({result.unit, numbers[std::minmax(result.a, result.b)],
                      matchOf(result.a < result.b ? result.points : 1.0 - result.points)});
  }
  return placed;
}

}  // namespace

double expectedPoints(double elo, double draw_share) {
  if (draw_share >= 1.0) return 0.5;
  const MatchChances chances = davidsonChances(elo / kEloPerLog, 2.0 * draw_share / (1.0 - draw_share));
  return chances.win + chances.draw / 2.0;
}

Ratings rate(std::size_t entrants, std::span<const MeetingCounts> meetings, std::uint64_t seed,
             std::size_t resamples) {
  std::vector<PairOutcomes> pairs;
  WeightedMeetings observed;
  for (const auto& [who, outcomes] : joined(meetings)) {
    pairs.push_back(outcomes);
    observed.push_back({who.first, who.second, static_cast<double>(outcomes.wins()),
                        static_cast<double>(outcomes.draws()), static_cast<double>(outcomes.losses())});
  }
  const std::vector<double> shapes = shapesOf(entrants, observed, pairs);
  const Reweigh reweigh = [&](Rng& rng, WeightedMeetings& weighed) {
    for (std::size_t m = 0; m < pairs.size(); ++m) {
      for (std::size_t i = 0; i < kPairOutcomes; ++i) {
        if (pairs[m].counts[i] == 0) continue;
        // The sum of the weights of all pairs with this outcome: gamma distributed, with their number times
        // the shape.
        const double weight = gammaDraw(rng, shapes[m] * static_cast<double>(pairs[m].counts[i])) / shapes[m];
        addMatches(weighed[m], weight, matchesOf(static_cast<PairOutcome>(i)));
      }
    }
  };
  return rateResampled(entrants, std::move(observed), reweigh, seed, resamples);
}

Ratings rateUnits(std::size_t entrants, std::size_t units, std::span<const UnitResult> results,
                  std::uint64_t seed, std::size_t resamples) {
  WeightedMeetings observed;
  const std::vector<PlacedResult> list = placed(results, observed);
  for (const PlacedResult& result : list) addMatches(observed[result.meeting], 1.0, result.match);
  std::vector<double> weights(units);
  const double shape = shapeOf(static_cast<double>(units), 1.0);
  const Reweigh reweigh = [&](Rng& rng, WeightedMeetings& weighed) {
    for (double& weight : weights) weight = gammaDraw(rng, shape) / shape;
    for (const PlacedResult& result : list)
      addMatches(weighed[result.meeting], weights[result.unit], result.match);
  };
  return rateResampled(entrants, std::move(observed), reweigh, seed, resamples);
}

}  // namespace fulbito
