#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace fulbito::test {

/// What went wrong in a simulation of shards.
struct ShardTroubles {
  std::size_t torn = 0;       ///< runs that died in the middle of a line, and were started again
  std::size_t lost = 0;       ///< logs that vanished with their machine, so that the shard began anew
  std::size_t moved = 0;      ///< shards that another machine began anew, while the first log stayed
  std::size_t delivered = 0;  ///< logs that were delivered twice
};

/// The logs of shards of a tournament whose runs die, vanish, are repeated and delivered twice, until each
/// shard has been completed at least once.
class ShardSimulation {
 public:
  /// Writes the logs into a folder. `trouble`: chance of each kind of trouble per shard and attempt.
  ShardSimulation(std::string folder, std::uint64_t matches, std::size_t shards, double trouble,
                  unsigned seed);

  /// All logs in an order that the seed decides.
  const std::vector<std::string>& files() const { return files_; }
  const ShardTroubles& troubles() const { return troubles_; }

 private:
  void runShard(std::size_t shard);
  /// @return whether the shard is complete
  bool attempt(const std::string& file, std::size_t shard);
  void tear(const std::string& file);
  bool chance() { return std::uniform_real_distribution<>()(random_) < trouble_; }
  std::string newFile(std::size_t shard);

  const std::string folder_;
  const std::uint64_t matches_;
  const std::size_t shards_;
  const double trouble_;
  std::mt19937 random_;
  std::vector<std::string> files_;
  ShardTroubles troubles_;
};

}  // namespace fulbito::test
