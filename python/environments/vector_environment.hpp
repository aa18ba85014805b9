#pragma once

#include <array>
#include <cstdint>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "python/environments/episode_runner.hpp"
#include "python/environments/worker_pool.hpp"

namespace fulbito {

/// What a vector does with an environment whose episode has ended.
enum class Autoreset : std::uint8_t {
  kNextStep,  ///< its next step begins a new episode: the action is ignored, and the reward is 0
  kSameStep,  ///< the step that ends an episode also begins the next; the last observation is kept apart
  kDisabled,  ///< the caller resets it
};

/// Arrays of the caller with a row per environment. They hold what the environments tell.
struct VectorRows {
  float* observations = nullptr;       ///< rows x agents x observation
  double* rewards = nullptr;           ///< rows x agents
  std::uint8_t* terminated = nullptr;  ///< rows x agents; 0 or 1, the same for all agents of a row
  std::uint8_t* truncated = nullptr;   ///< rows x agents
  double* terms = nullptr;             ///< rows x agents x terms
  double* figures = nullptr;           ///< rows x figures
};

/// The last moment of episodes that ended with kSameStep.
struct FinalRows {
  float* observations = nullptr;   ///< rows x agents x observation
  double* figures = nullptr;       ///< rows x figures
  std::uint8_t* filled = nullptr;  ///< rows: 1 if the last step ended an episode
};

/// The arrays of a vector. Successive calls write into `all[0]` and `all[1]` in turn, so that what one call
/// told stays as it is until the call after the next.
struct VectorArrays {
  std::array<VectorRows, 2> all;
  std::array<VectorRows, 2> some;  ///< rows of a `send` of some environments, in its order
  FinalRows last;                  ///< rows of all environments; used with kSameStep
};

/// How a vector plays.
struct VectorSettings {
  int threads = 0;  ///< 0: one per core. Results never depend on it
  Autoreset autoreset = Autoreset::kNextStep;
  bool remembers = false;  ///< keeps the actions of the present episodes, for `state`
};

/// Environments of one shape that several threads step. Once warm, a step allocates nothing except where the
/// environments do. One thread at a time may call it.
class VectorEnvironment {
 public:
  /// Errors: kUsage if there is no environment, there are more than WorkerPool::kMostTasks, or their shapes
  /// differ.
  static Result<std::unique_ptr<VectorEnvironment>> create(
      std::vector<std::unique_ptr<EpisodeSource>> sources, const VectorSettings& settings);
  ~VectorEnvironment();

  /// Sets the arrays, which must outlive the vector or the next `use`.
  void use(const VectorArrays& arrays) { arrays_ = arrays; }
  const EpisodeShape& shape() const { return runners_.front().shape(); }
  std::size_t size() const { return runners_.size(); }
  int threads() const { return pool_.threads(); }
  /// Whether this process is a child of the one that created the vector: it does not have its threads.
  bool forked() const { return pool_.forked(); }
  /// Whether a `send` waits for its `receive`.
  bool isUnderWay() const { return under_way_; }

  /// The next episode of environment `i` is the first one of this seed.
  void seed(std::size_t i, std::uint64_t seed) { runners_[i].seed(seed); }
  /// Begins new episodes, of all environments or of those whose entry of `mask` is true; rows of the others
  /// stay. Errors: as `EpisodeSource::begin`, of the first environment that has one.
  /// @return which of `VectorArrays::all` has the rows
  Result<int> reset(std::span<const bool> mask, const std::string& text = {});
  /// The first environment that cannot be stepped, if any: no episode of it has begun, or the last one is
  /// over and the vector resets nothing. `ids` as `send`.
  std::optional<std::size_t> firstIdle(std::span<const std::uint32_t> ids) const;
  /// Begins a step of all environments, or of those of `ids` (distinct), and returns at once. It copies
  /// `actions`, which `flawOfActions` has found right: those of each environment in turn. None may be idle.
  void send(std::span<const float> actions, std::span<const std::uint32_t> ids);
  /// Waits for the step. Errors: of the first environment in the order of `send` that has one; it needs a
  /// reset. Throws the exception that one has thrown.
  /// @return which of `VectorArrays::all`, or of `some` after a `send` with ids, has the rows
  Result<int> receive();
  /// `send` and `receive` of all environments.
  Result<int> step(std::span<const float> actions) {
    send(actions, {});
    return receive();
  }

  EpisodeRunner& operator[](std::size_t i) { return runners_[i]; }
  /// Puts environment `i` into that state; its rows of the arrays that the last call wrote follow. Errors: as
  /// `EpisodeRunner::restore`.
  Result<void> restore(std::size_t i, const EpisodeState& state);

 private:
  VectorEnvironment(std::vector<std::unique_ptr<EpisodeSource>> sources, const VectorSettings& settings);
  EpisodeView viewOf(const VectorRows& rows, std::size_t row) const;
  void mark(const VectorRows& rows, std::size_t row, EpisodeEnd end) const;
  void copyRow(const VectorRows& from, std::size_t row, const VectorRows& to, std::size_t to_row) const;
  void keepLast(const EpisodeView& view, std::size_t i) const;
  void run(std::size_t task);
  Result<void> stepOne(std::size_t i, std::size_t task, const VectorRows& rows);
  void begin();
  Result<void> finish();
  const VectorRows& newest() const { return arrays_.all[static_cast<std::size_t>(all_)]; }

  std::vector<EpisodeRunner> runners_;
  Autoreset autoreset_;
  VectorArrays arrays_;
  std::vector<std::uint32_t> everyone_;  ///< 0 ... size - 1
  std::vector<std::uint32_t> sent_;      ///< environments of the step under way
  std::vector<float> actions_;           ///< theirs
  std::vector<std::optional<Error>> errors_;
  std::vector<std::exception_ptr> exceptions_;
  std::string text_;  ///< of the reset under way
  int all_ = 0;       ///< the newest of `VectorArrays::all`
  int some_ = 0;
  bool resets_ = false;  ///< the tasks under way are resets
  bool partly_ = false;  ///< the step under way is of some environments
  bool under_way_ = false;
  WorkerPool pool_;  // last: its threads use the rest
};

}  // namespace fulbito
