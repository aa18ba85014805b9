#include "tournament/statistics/davidson.hpp"

#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

DavidsonModel fitted(std::size_t entrants, const std::vector<WeightedMeeting>& meetings,
                     std::vector<double> prior = {}) {
  prior.resize(entrants, 0.0);
  DavidsonModel model{std::vector<double>(entrants, 0.0), 0.0};
  DavidsonFitter(std::vector<int>(entrants, 0)).fit(meetings, prior, 1e-12, model);
  return model;
}

}  // namespace

TEST_CASE("chances follow Davidson's formula", "[unit]") {
  const double p = 3.0, q = 0.5, nu = 0.7, sum = p + q + nu * std::sqrt(p * q);
  const MatchChances chances = davidsonChances(math::log(p / q), nu);
  CHECK(chances.win == Approx(p / sum));
  CHECK(chances.draw == Approx(nu * std::sqrt(p * q) / sum));
  CHECK(chances.loss == Approx(q / sum));
  const MatchChances turned = davidsonChances(math::log(q / p), nu);
  CHECK(turned.win == Approx(chances.loss));
  CHECK(turned.draw == Approx(chances.draw));
  CHECK(davidsonChances(5000.0, 1.0).win == 1.0);
}

TEST_CASE("two entrants have Davidson's closed form", "[unit]") {
  // With p / q = wins / losses and nu = draws / sqrt(wins losses), the model has exactly the observed
  // frequencies.
  const DavidsonModel model = fitted(2, {{0, 1, 6, 3, 1}});
  CHECK(model.strength[0] - model.strength[1] == Approx(math::log(6.0)));
  CHECK(math::exp(model.log_draw) == Approx(3.0 / std::sqrt(6.0)));
  CHECK(model.strength[0] + model.strength[1] == Approx(0.0).margin(1e-9));
}

TEST_CASE("a baseball season has the published Bradley-Terry estimates", "[unit]") {
  // American League East, 1987: A. Agresti, "Categorical Data Analysis", 2nd edition, section 10.6. Estimates
  // relative to Baltimore: H. Turner and D. Firth, "Bradley-Terry models in R: the BradleyTerry2 package"
  // (2012), without home advantage.
  enum Club : std::size_t { kMilwaukee, kDetroit, kToronto, kNewYork, kBoston, kCleveland, kBaltimore };
  const DavidsonModel model =
      fitted(7, {{kMilwaukee, kDetroit, 7, 0, 6},   {kMilwaukee, kToronto, 9, 0, 4},
                 {kMilwaukee, kNewYork, 7, 0, 6},   {kMilwaukee, kBoston, 7, 0, 6},
                 {kMilwaukee, kCleveland, 9, 0, 4}, {kMilwaukee, kBaltimore, 11, 0, 2},
                 {kDetroit, kToronto, 7, 0, 6},     {kDetroit, kNewYork, 5, 0, 8},
                 {kDetroit, kBoston, 11, 0, 2},     {kDetroit, kCleveland, 9, 0, 4},
                 {kDetroit, kBaltimore, 9, 0, 4},   {kToronto, kNewYork, 7, 0, 6},
                 {kToronto, kBoston, 7, 0, 6},      {kToronto, kCleveland, 8, 0, 5},
                 {kToronto, kBaltimore, 12, 0, 1},  {kNewYork, kBoston, 6, 0, 7},
                 {kNewYork, kCleveland, 7, 0, 6},   {kNewYork, kBaltimore, 10, 0, 3},
                 {kBoston, kCleveland, 7, 0, 6},    {kBoston, kBaltimore, 12, 0, 1},
                 {kCleveland, kBaltimore, 6, 0, 7}});
  const auto over_baltimore = [&](Club club) { return model.strength[club] - model.strength[kBaltimore]; };
  CHECK(over_baltimore(kMilwaukee) == Approx(1.5814).margin(1e-3));
  CHECK(over_baltimore(kDetroit) == Approx(1.4364).margin(1e-3));
  CHECK(over_baltimore(kToronto) == Approx(1.2945).margin(1e-3));
  CHECK(over_baltimore(kNewYork) == Approx(1.2476).margin(1e-3));
  CHECK(over_baltimore(kBoston) == Approx(1.1077).margin(1e-3));
  CHECK(over_baltimore(kCleveland) == Approx(0.6839).margin(1e-3));
}

TEST_CASE("at the maximum, points and draws are as many as expected", "[unit]") {
  const std::vector<WeightedMeeting> meetings{
      {0, 1, 5, 3, 2}, {0, 2, 7, 1.5, 0}, {1, 2, 4, 4, 1}, {2, 3, 0.5, 6, 3}, {0, 3, 2, 2, 2}};
  const DavidsonModel model = fitted(4, meetings);
  std::vector<double> missing(4, 0.0);
  double draws = 0.0;
  for (const WeightedMeeting& m : meetings) {
    const double n = m.wins + m.draws + m.losses;
    const MatchChances chances =
        davidsonChances(model.strength[m.a] - model.strength[m.b], math::exp(model.log_draw));
    const double points = m.wins + m.draws / 2 - n * (chances.win + chances.draw / 2);
    missing[m.a] += points;
    missing[m.b] -= points;
    draws += m.draws - n * chances.draw;
  }
  for (const double points : missing) CHECK(points == Approx(0.0).margin(1e-9));
  CHECK(draws == Approx(0.0).margin(1e-9));
}

TEST_CASE("the prior's matches are against a fictitious entrant of strength 0", "[unit]") {
  // By symmetry the second strength is -x. The first wins 10 of 10, and each has w wins and w losses against
  // 0.
  const double w = 0.5;
  const double x = fitted(2, {{0, 1, 10, 0, 0}}, {w, w}).strength[0];
  const double missing =
      10.0 * (1.0 - davidsonChances(2 * x, 0.0).win) + w - 2 * w * davidsonChances(x, 0.0).win;
  CHECK(x > 1.0);
  CHECK(missing == Approx(0.0).margin(1e-9));
}

TEST_CASE("a maximum far from the start is found", "[unit]") {
  const DavidsonModel model = fitted(2, {{0, 1, 1e9, 1, 1e-3}});
  CHECK(model.strength[0] - model.strength[1] == Approx(math::log(1e12)).epsilon(1e-6));
}
