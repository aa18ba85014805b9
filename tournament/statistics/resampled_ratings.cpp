#include "tournament/statistics/resampled_ratings.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "fulbito/detail/math.hpp"
#include "tournament/statistics/gamma.hpp"
#include "tournament/statistics/win_graph.hpp"

namespace fulbito {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPriorPairs = 0.5;     // prior: pairs of each entrant against the fictitious one
constexpr double kFitAccuracy = 1e-12;  // error of log p
constexpr double kResampleAccuracy = 1e-6;
constexpr double kTie = 1e-6;  // [Elo] smaller leads are rounding errors and count as ties

/// Fits ratings to the results and to their resamples. Keeps what all fits share.
class Rater {
 public:
  Rater(std::size_t entrants, WeightedMeetings observed)
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

  /// Elo by entrant, from the results without random weights. Call it first: resamples start from its
  /// solution.
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

  /// Sets the draw parameter at which equal entrants would have the observed share of draws.
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

  /// Strengths as Elo by entrant, with mean 0 in each component.
  std::vector<double> eloOfModel(const DavidsonModel& model) const {
    std::vector<double> means(sizes_.size(), 0.0), elo(model.strength.size());
    const auto group = [&](std::size_t i) { return static_cast<std::size_t>(graph_.component[i]); };
    for (std::size_t i = 0; i < elo.size(); ++i) means[group(i)] += model.strength[i] / sizes_[group(i)];
    for (std::size_t i = 0; i < elo.size(); ++i) elo[i] = kEloPerLog * (model.strength[i] - means[group(i)]);
    return elo;
  }

  WeightedMeetings observed_, weighed_;
  WinGraph graph_;
  DavidsonFitter fitter_;
  std::vector<double> sizes_;  ///< number of entrants by component
  std::vector<double> prior_;  ///< see `DavidsonFitter::fit`
  DavidsonModel model_;
};

/// Share of the resamples in which the first entrant is rated above the second; a tie counts half.
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

}  // namespace

Ratings rateResampled(std::size_t entrants, WeightedMeetings observed, const Reweigh& reweigh,
                      std::uint64_t seed, std::size_t resamples) {
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

}  // namespace fulbito
