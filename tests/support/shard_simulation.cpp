#include "tests/support/shard_simulation.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "tests/support/match_rows.hpp"
#include "tournament/store/match_log.hpp"

namespace fulbito::test {

namespace fs = std::filesystem;

ShardSimulation::ShardSimulation(std::string folder, std::uint64_t matches, std::size_t shards,
                                 double trouble, unsigned seed)
    : folder_(std::move(folder)), matches_(matches), shards_(shards), trouble_(trouble), random_(seed) {
  for (std::size_t shard = 0; shard < shards_; ++shard) runShard(shard);
  std::shuffle(files_.begin(), files_.end(), random_);
}

void ShardSimulation::runShard(std::size_t shard) {
  std::string file = newFile(shard);
  while (!attempt(file, shard)) {
    if (chance()) {
      fs::remove(file);
      ++troubles_.lost;
    } else if (chance()) {
      files_.push_back(std::exchange(file, newFile(shard)));
      ++troubles_.moved;
    }
  }
  files_.push_back(file);
  if (!chance()) return;
  const std::string copy = newFile(shard);
  fs::copy_file(file, copy);
  files_.push_back(copy);
  ++troubles_.delivered;
}

bool ShardSimulation::attempt(const std::string& file, std::size_t shard) {
  const bool dies = chance();
  const std::uint64_t until =
      dies ? std::uniform_int_distribution<std::uint64_t>(0, matches_)(random_) : matches_;
  {
    const auto log = MatchLog::open(file);
    if (!log) throw std::runtime_error(log.error().message);
    for (std::uint64_t match = shard; match < until; match += shards_) {
      const auto added = (*log)->add(matchRow(match));
      if (!added || added == Added::kDifferent) throw std::runtime_error("a match was not kept");
    }
  }
  if (dies) tear(file);
  return !dies;
}

void ShardSimulation::tear(const std::string& file) {
  const auto size = fs::file_size(file);
  fs::resize_file(file, size - std::uniform_int_distribution<std::uintmax_t>(
                                   0, std::min<std::uintmax_t>(size, 200))(random_));
  ++troubles_.torn;
}

std::string ShardSimulation::newFile(std::size_t shard) {
  for (int copy = 0;; ++copy) {
    const std::string file = fmt::format("{}/shard-{}-{}.jsonl", folder_, shard, copy);
    if (!fs::exists(file) && std::find(files_.begin(), files_.end(), file) == files_.end()) return file;
  }
}

}  // namespace fulbito::test
