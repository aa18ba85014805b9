#pragma once

#include <stdexcept>
#include <string>

#include "python/environments/episodes.hpp"

namespace fulbito::test {

/// Episodes whose observation is the seed's last digits and the sum of the actions so far. They end after
/// `length` steps. An action of 0.5 is an error, one of 0.25 an exception.
class CountingSource final : public EpisodeSource {
 public:
  explicit CountingSource(int length) : length_(length) {
    shape_.observation = 2;
    shape_.bound = 1000.0f;
    shape_.action = 1;
    shape_.terms = {"action"};
    shape_.figures = {"steps"};
  }
  const EpisodeShape& shape() const override { return shape_; }
  Result<void> begin(const EpisodeStart& start, const EpisodeView& out) override {
    if (start.text == "nowhere") return fail(ErrorCode::kUsage, "start: nowhere");
    seed_ = static_cast<float>(start.seed % 1000);
    sum_ = 0.0f;
    steps_ = 0;
    for (double& reward : out.rewards) reward = 0.0;
    for (double& term : out.terms) term = 0.0;
    tell(out);
    return {};
  }
  Result<EpisodeEnd> step(std::span<const float> actions, const EpisodeView& out) override {
    if (actions[0] == 0.5f) return fail(ErrorCode::kMachine, "no room");
    if (actions[0] == 0.25f) throw std::runtime_error("thrown");
    sum_ += actions[0];
    ++steps_;
    out.rewards[0] = out.terms[0] = static_cast<double>(actions[0]);
    tell(out);
    return EpisodeEnd{steps_ == length_, false};
  }

 private:
  void tell(const EpisodeView& out) const {
    out.observations[0] = seed_;
    out.observations[1] = sum_;
    out.figures[0] = steps_;
  }
  EpisodeShape shape_;
  int length_;
  float seed_ = 0.0f, sum_ = 0.0f;
  int steps_ = 0;
};

}  // namespace fulbito::test
