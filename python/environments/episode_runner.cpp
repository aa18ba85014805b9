#include "python/environments/episode_runner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "engine/core/math/random.hpp"

namespace fulbito {

EpisodeRunner::EpisodeRunner(std::unique_ptr<EpisodeSource> source, bool remembers)
    : source_(std::move(source)), remembers_(remembers) {}

void EpisodeRunner::seed(std::uint64_t seed) {
  state_.seed = seed;
  state_.episodes = 0;
}

Result<void> EpisodeRunner::begin(const EpisodeStart& start, const EpisodeView& out) {
  state_.actions.clear();
  state_.start = start;
  phase_ = Phase::kBroken;
  if (auto begun = source_->begin(start, out); !begun) return begun;
  phase_ = Phase::kRunning;
  return {};
}

Result<void> EpisodeRunner::reset(const EpisodeView& out, const std::string& text) {
  const std::uint64_t seed = Rng(state_.seed, Stream::kEpisodes, state_.episodes++).bits64();
  return begin({seed, text}, out);
}

Result<EpisodeEnd> EpisodeRunner::step(std::span<const float> actions, const EpisodeView& out) {
  if (remembers_) state_.actions.insert(state_.actions.end(), actions.begin(), actions.end());
  phase_ = Phase::kBroken;
  auto end = source_->step(actions, out);
  if (end) phase_ = end->any() ? Phase::kOver : Phase::kRunning;
  return end;
}

Result<EpisodeEnd> EpisodeRunner::restore(const EpisodeState& state, const EpisodeView& out) {
  const std::size_t size = shape().agents * shape().action;
  if (state.actions.size() % size != 0 || flawOfActions(shape(), state.actions)) {
    return fail(ErrorCode::kUsage, "the state is not one of this environment");
  }
  EpisodeState wanted;
  wanted = state;  // it may be this runner's own
  state_.seed = wanted.seed;
  state_.episodes = wanted.episodes;
  if (!wanted.start) {
    state_.start.reset();
    state_.actions.clear();
    phase_ = Phase::kFresh;
    return EpisodeEnd{};
  }
  if (auto begun = begin(*wanted.start, out); !begun) return tl::unexpected<Error>(begun.error());
  EpisodeEnd end;
  for (std::size_t i = 0; i < wanted.actions.size(); i += size) {
    if (phase_ != Phase::kRunning) return fail(ErrorCode::kUsage, "the state is not one of this environment");
    const auto played = step(std::span(wanted.actions).subspan(i, size), out);
    if (!played) return played;
    end = *played;
  }
  return end;
}

std::optional<std::string> flawOfActions(const EpisodeShape& shape, std::span<const float> actions) {
  const auto choices = static_cast<float>(shape.choices);
  for (std::size_t i = 0; i < actions.size(); ++i) {
    const float action = actions[i];
    if (!std::isfinite(action)) return fmt::format("actions: number {} is {}, not finite", i, action);
    if (shape.choices == 0) continue;
    if (action < 0.0f || action >= choices || action != std::floor(action)) {
      return fmt::format("actions: {} is no choice of 0 ... {}", action, shape.choices - 1);
    }
  }
  return std::nullopt;
}

}  // namespace fulbito
