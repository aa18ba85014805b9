#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// Sizes and names of an environment. They never change.
struct EpisodeShape {
  std::size_t agents = 1;       ///< robots that the caller drives, each with observation, action and reward
  std::size_t observation = 0;  ///< numbers of an agent's observation
  float bound = 1.0f;           ///< observations lie within -bound ... bound; what lies beyond is clipped
  std::size_t action = 0;       ///< numbers of an agent's action, each within -1 ... 1
  /// Not 0: an agent's action is one whole number 0 ... choices - 1, and `action` is 1.
  std::size_t choices = 0;
  std::size_t state = 0;             ///< numbers of `EpisodeSource::state`
  std::vector<std::string> terms;    ///< names of the terms whose sum is an agent's reward
  std::vector<std::string> figures;  ///< names of what else is told after each step
};

/// Where an environment writes what it tells. The caller owns the memory.
struct EpisodeView {
  std::span<float> observations;  ///< agents x observation
  std::span<double> rewards;      ///< one per agent; `begin` may get none
  std::span<double> terms;        ///< agents x terms; `begin` may get none
  std::span<double> figures;      ///< as `EpisodeShape::figures`
};

/// All that determines an episode but its actions.
struct EpisodeStart {
  std::uint64_t seed = 0;  ///< of all random numbers of the episode
  /// Where it begins, in words that the environment knows; empty: as it is configured.
  std::string text;
  friend bool operator==(const EpisodeStart&, const EpisodeStart&) = default;
};

/// Whether a step ended the episode.
struct EpisodeEnd {
  bool terminated = false;  ///< what follows has no value: a goal, the end of a match, a task that is done
  bool truncated = false;   ///< the time is up
  bool any() const { return terminated || truncated; }
};

/// One environment: it plays one episode after the other. Equal starts and actions give equal episodes, bit
/// for bit, whatever was played before. Single-threaded; separate ones may run on separate threads. `step`
/// allocates nothing once warm, except where a play of a match begins.
class EpisodeSource {
 public:
  virtual ~EpisodeSource() = default;
  virtual const EpisodeShape& shape() const = 0;
  /// Begins an episode. Writes the first observation and figures; rewards and terms become 0. Errors: kUsage
  /// and kBadInput for a start that is not possible; those of a match.
  virtual Result<void> begin(const EpisodeStart& start, const EpisodeView& out) = 0;
  /// Plays one step. Not to be called before `begin` or after the end.
  /// @param actions  agents x action, finite; numbers beyond -1 ... 1 count as the nearer end
  /// Errors: kMachine, kInterrupted if the episode cannot go on.
  virtual Result<EpisodeEnd> step(std::span<const float> actions, const EpisodeView& out) = 0;
  /// Writes the state of the whole world for a critic, `EpisodeShape::state` numbers.
  virtual void state(std::span<float>) const {}
  /// Records the next episode into a file. It is complete when the episode ends, when the next one begins, or
  /// with the environment. Errors: kUsage if this environment has no recordings.
  virtual Result<void> record(const std::string& file);
  /// A picture of the present moment, `width` pixels wide. Errors: kUsage for a width that is not possible,
  /// or if this environment has no pictures.
  virtual Result<Canvas> picture(int width);
};

}  // namespace fulbito
