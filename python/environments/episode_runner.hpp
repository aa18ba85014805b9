#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "python/environments/episodes.hpp"

namespace fulbito {

/// The state of an environment as a value: how its episode began, and the actions since. Whoever has it can
/// play on from there in any environment of the same configuration.
struct EpisodeState {
  std::uint64_t seed = 0;      ///< of the environment's own stream, from which episodes get their seeds
  std::uint64_t episodes = 0;  ///< drawn from that stream so far
  std::optional<EpisodeStart> start;  ///< of the present episode; empty before the first one
  std::vector<float> actions;         ///< steps x agents x action
};

/// One environment with its seeds and the state of its episode.
class EpisodeRunner {
 public:
  /// The phases of an environment.
  enum class Phase : std::uint8_t {
    kFresh,    ///< no episode has begun
    kRunning,  ///< amid an episode
    kOver,     ///< the episode has ended
    kBroken,   ///< the episode could not go on
  };

  /// @param remembers  keeps the actions of the present episode, for `state`
  EpisodeRunner(std::unique_ptr<EpisodeSource> source, bool remembers);

  /// The next episode is the first one of this seed.
  void seed(std::uint64_t seed);
  /// Begins the next episode. @param text  as `EpisodeStart::text`. Errors: as `EpisodeSource::begin`.
  Result<void> reset(const EpisodeView& out, const std::string& text = {});
  /// Plays one step; only in phase kRunning. Errors: as `EpisodeSource::step`.
  Result<EpisodeEnd> step(std::span<const float> actions, const EpisodeView& out);
  /// Plays the episode of `state` again up to its last action, and writes what the last step told.
  /// @return how that step ended
  /// Errors: kUsage if the state is not one of this environment; as `reset` and `step`.
  Result<EpisodeEnd> restore(const EpisodeState& state, const EpisodeView& out);

  /// The present state. Empty actions if the runner does not remember them.
  const EpisodeState& state() const { return state_; }
  bool remembers() const { return remembers_; }
  Phase phase() const { return phase_; }
  EpisodeSource& source() { return *source_; }
  const EpisodeShape& shape() const { return source_->shape(); }

 private:
  Result<void> begin(const EpisodeStart& start, const EpisodeView& out);

  std::unique_ptr<EpisodeSource> source_;
  EpisodeState state_;
  bool remembers_;
  Phase phase_ = Phase::kFresh;
};

/// What is wrong with actions of an environment; empty: nothing. `actions` are those of any number of agents.
std::optional<std::string> flawOfActions(const EpisodeShape& shape, std::span<const float> actions);

}  // namespace fulbito
