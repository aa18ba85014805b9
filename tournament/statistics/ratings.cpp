#include "tournament/statistics/ratings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <utility>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tournament/statistics/davidson.hpp"
#include "tournament/statistics/gamma.hpp"
#include "tournament/statistics/win_graph.hpp"

namespace fulbito {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEloPerLog = 173.71779276130073;  // 400 / ln 10
constexpr double kPriorPairs = 0.5;                // pairs against the fictitious entrant
constexpr double kFitAccuracy = 1e-12;             // of log p
constexpr double kResampleAccuracy = 1e-6;
constexpr double kLeastShape = 0.5;
constexpr double kTie = 1e-6;  // Elo; leads below it are rounding errors

using Meetings = std::vector<WeightedMeeting>;
/// Adds the randomly weighted results to meetings without any.
using Reweigh = std::function<void(Rng&, Meetings&)>;
using EntrantPair = std::pair<std::size_t, std::size_t>;

void addMatches(WeightedMeeting& meeting, double weight, const PairMatches& matches) {
  meeting.wins += weight * matches.wins;
  meeting.draws += weight * matches.draws;
  meeting.losses += weight * matches.losses;
}

/// What does not change between the resamples of one set of results.
class Rater {
 public:
  Rater(std::size_t entrants, Meetings observed)
      : observed_(std::move(observed)), graph_(winGraph(entrants, observed_)), fitter_(graph_.component) {
    for (const int group : graph_.component) sizes_.resize(std::max<std::size_t>(sizes_.size(), group + 1));
    for (const int group : graph_.component) sizes_[static_cast<std::size_t>(group)] += 1.0;
    model_.strength.assign(entrants, 0.0);
    prior_.assign(entrants, 0.0);
    startDraws();
  }

  const WinGraph& graph() const { return graph_; }
  bool prior() const {
    return std::find(graph_.without_bound.begin(), graph_.without_bound.end(), true) !=
           graph_.without_bound.end();
  }
  bool met(std::size_t entrant) const {
    return sizes_[static_cast<std::size_t>(graph_.component[entrant])] > 1.0;
  }

  /// Elo by entrant of the results as they are. Call it first: resamples start from it.
  std::vector<double> fit() {
    weighPrior([] { return kPriorPairs; });
    fitter_.fit(observed_, prior_, kFitAccuracy, model_);
    return eloOfModel(model_);
  }

  /// Elo by entrant of one resample.
  std::vector<double> resample(Rng& rng, const Reweigh& reweigh) {
    weighed_ = observed_;
    for (WeightedMeeting& meeting : weighed_) meeting.wins = meeting.draws = meeting.losses = 0.0;
    reweigh(rng, weighed_);
    weighPrior([&] { return gammaDraw(rng, kPriorPairs); });
    DavidsonModel model = model_;
    fitter_.fit(weighed_, prior_, kResampleAccuracy, model);
    return eloOfModel(model);
  }

  double drawShare() const { return drawn() ? davidsonChances(0.0, math::exp(model_.log_draw)).draw : 0.0; }

 private:
  bool drawn() const {
    return std::any_of(observed_.begin(), observed_.end(),
                       [](const WeightedMeeting& m) { return m.draws > 0.0; });
  }

  /// Starts from the draw parameter that equal entrants would have.
  void startDraws() {
    double draws = 0.0, decided = 1.0;
    for (const WeightedMeeting& m : observed_) draws += m.draws, decided += m.wins + m.losses;
    if (draws > 0.0) model_.log_draw = math::log(2.0 * draws / decided);
  }

  void weighPrior(const std::function<double()>& draw) {
    for (std::size_t i = 0; i < prior_.size(); ++i) {
      if (graph_.without_bound[static_cast<std::size_t>(graph_.component[i])]) prior_[i] = draw();
    }
  }

  /// In Elo, with mean 0 in each component.
  std::vector<double> eloOfModel(const DavidsonModel& model) const {
    std::vector<double> means(sizes_.size(), 0.0), elo(model.strength.size());
    const auto group = [&](std::size_t i) { return static_cast<std::size_t>(graph_.component[i]); };
    for (std::size_t i = 0; i < elo.size(); ++i) means[group(i)] += model.strength[i] / sizes_[group(i)];
    for (std::size_t i = 0; i < elo.size(); ++i) elo[i] = kEloPerLog * (model.strength[i] - means[group(i)]);
    return elo;
  }

  Meetings observed_, weighed_;
  WinGraph graph_;
  DavidsonFitter fitter_;
  std::vector<double> sizes_;  ///< entrants by component
  std::vector<double> prior_;  ///< see DavidsonFitter::fit
  DavidsonModel model_;
};

/// How often the first of two sets of resampled ratings is above the second; a tie counts half.
double shareAbove(const std::vector<double>& first, const std::vector<double>& second) {
  double above = 0.0;
  for (std::size_t k = 0; k < first.size(); ++k) {
    const double lead = first[k] - second[k];
    above += lead > kTie ? 1.0 : lead < -kTie ? 0.0 : 0.5;
  }
  return first.empty() ? 0.5 : above / static_cast<double>(first.size());
}

void fillSuperiority(const std::vector<std::vector<double>>& samples, Ratings& ratings) {
  const std::size_t n = samples.size();
  ratings.superiority.assign(n, std::vector<double>(n, 0.5));
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (ratings.component[i] != ratings.component[j]) continue;
      ratings.superiority[i][j] = shareAbove(samples[i], samples[j]);
      ratings.superiority[j][i] = 1.0 - ratings.superiority[i][j];
    }
  }
}

Ratings rateBy(std::size_t entrants, Meetings observed, const Reweigh& reweigh, std::uint64_t seed,
               std::size_t resamples) {
  Rater rater(entrants, std::move(observed));
  Ratings ratings;
  for (const double elo : rater.fit()) ratings.elo.push_back({elo, -kInfinity, kInfinity});
  ratings.component = rater.graph().component;
  ratings.prior = rater.prior();
  ratings.draw_share = rater.drawShare();
  std::vector<std::vector<double>> samples(entrants, std::vector<double>(resamples));
  for (std::size_t k = 0; k < resamples; ++k) {
    Rng rng(seed, Stream::kRatings, k);
    const std::vector<double> elo = rater.resample(rng, reweigh);
    for (std::size_t i = 0; i < entrants; ++i) samples[i][k] = elo[i];
  }
  fillSuperiority(samples, ratings);
  for (std::size_t i = 0; i < entrants; ++i) {
    if (samples[i].empty() || !rater.met(i)) continue;
    ratings.elo[i].low = quantile(samples[i], 0.025);
    ratings.elo[i].high = quantile(samples[i], 0.975);
  }
  return ratings;
}

/// The same pairs as B sees them.
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

/// One meeting for each two entrants, in order.
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

/// The shape of the gamma distribution of a weight where `units` results say something about `unknowns`
/// ratings. Exp(1), of shape 1, would make intervals too narrow by the ratings fitted to the same results;
/// the variance grows as that of residuals does. For two entrants it is then that of the mean score.
double shapeOf(double units, double unknowns) {
  return std::max(kLeastShape, (units - unknowns) / std::max(1.0, units));
}

/// That shape for the pairs of each meeting, by the pairs and entrants of its component.
std::vector<double> shapesOf(std::size_t entrants, const Meetings& observed,
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

/// A result of a unit with the index of its meeting.
struct PlacedResult {
  std::size_t unit, meeting;
  PairMatches match;
};

PairMatches matchOf(double points) {
  return {points > 0.75 ? 1 : 0, points > 0.25 && points <= 0.75 ? 1 : 0, points <= 0.25 ? 1 : 0};
}

/// Numbers meetings in order of their entrants and finds the meeting of each result.
std::vector<PlacedResult> placed(std::span<const UnitResult> results, Meetings& meetings) {
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
  Meetings observed;
  for (const auto& [who, outcomes] : joined(meetings)) {
    pairs.push_back(outcomes);
    observed.push_back({who.first, who.second, static_cast<double>(outcomes.wins()),
                        static_cast<double>(outcomes.draws()), static_cast<double>(outcomes.losses())});
  }
  const std::vector<double> shapes = shapesOf(entrants, observed, pairs);
  const Reweigh reweigh = [&](Rng& rng, Meetings& weighed) {
    for (std::size_t m = 0; m < pairs.size(); ++m) {
      for (std::size_t i = 0; i < kPairOutcomes; ++i) {
        if (pairs[m].counts[i] == 0) continue;
        // The sum of as many weights of pairs.
        const double weight = gammaDraw(rng, shapes[m] * static_cast<double>(pairs[m].counts[i])) / shapes[m];
        addMatches(weighed[m], weight, matchesOf(static_cast<PairOutcome>(i)));
      }
    }
  };
  return rateBy(entrants, std::move(observed), reweigh, seed, resamples);
}

Ratings rateUnits(std::size_t entrants, std::size_t units, std::span<const UnitResult> results,
                  std::uint64_t seed, std::size_t resamples) {
  Meetings observed;
  const std::vector<PlacedResult> list = placed(results, observed);
  for (const PlacedResult& result : list) addMatches(observed[result.meeting], 1.0, result.match);
  std::vector<double> weights(units);
  const double shape = shapeOf(static_cast<double>(units), 1.0);
  const Reweigh reweigh = [&](Rng& rng, Meetings& weighed) {
    for (double& weight : weights) weight = gammaDraw(rng, shape) / shape;
    for (const PlacedResult& result : list)
      addMatches(weighed[result.meeting], weights[result.unit], result.match);
  };
  return rateBy(entrants, std::move(observed), reweigh, seed, resamples);
}

}  // namespace fulbito
