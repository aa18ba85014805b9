#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "python/environments/episodes.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::test {

/// An environment of one agent, with memory for what it tells.
template <typename Environment>
struct OneAgent {
  std::unique_ptr<Environment> environment;
  std::vector<float> observation;
  std::vector<double> rewards{0.0}, terms, figures;

  template <typename Settings>
  explicit OneAgent(const Settings& settings) {
    auto made = Environment::create(settings);
    if (!made) FAIL(made.error().message);
    environment = std::move(*made);
    observation.resize(environment->shape().observation);
    terms.resize(environment->shape().terms.size());
    figures.resize(environment->shape().figures.size());
  }

  EpisodeView view() { return {observation, rewards, terms, figures}; }
  void begin(const EpisodeStart& start) {
    const auto begun = environment->begin(start, view());
    if (!begun) FAIL(begun.error().message);
  }
  /// Plays a step, and checks that the reward is the sum of its terms and that the observation is within its
  /// bound.
  EpisodeEnd step(const std::vector<float>& action) {
    const auto end = environment->step(action, view());
    if (!end) FAIL(end.error().message);
    double sum = 0.0;
    for (const double term : terms) sum += term;
    REQUIRE(rewards[0] == sum);
    for (const float number : observation) REQUIRE(std::abs(number) <= environment->shape().bound);
    return *end;
  }
};

}  // namespace fulbito::test
