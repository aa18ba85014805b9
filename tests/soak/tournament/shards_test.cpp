#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/match_rows.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/shard_simulation.hpp"
#include "tests/support/shared_values.hpp"
#include "tests/support/watched_calls.hpp"
#include "tournament/store/match_line.hpp"
#include "tournament/store/merge.hpp"

namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMatches = 100000;

std::string undisturbed(std::uint64_t matches) {
  std::map<MatchId, std::string> lines;
  for (std::uint64_t i = 0; i < matches; ++i) lines[matchRow(i).id] = toLine(matchRow(i));
  std::string text(logHeader());
  for (const auto& [id, line] : lines) text += line;
  return text;
}

/// What a merge costs.
struct Cost {
  double read = 0, write = 0;  ///< [s] of computing
  double wall = 0;             ///< [s] of both
  double memory = 0;           ///< [MB] at most, beyond what the process had before
  double repeated = 0;         ///< rows
};

double computing() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// A line of /proc/self/status [MB].
double memory(const std::string& key) {
  std::ifstream status("/proc/self/status");
  std::string word;
  while (status >> word && word != key) {
  }
  double kibibytes = 0;
  status >> kibibytes;
  return kibibytes * 1024e-6;
}

/// Memory now, which becomes the peak so far too: without what the parent has freed.
double memoryFromHere() {
  ::malloc_trim(0);
  std::ofstream("/proc/self/clear_refs") << 5;
  return memory("VmRSS:");
}

Cost costOf(const std::vector<std::string>& files, const std::string& out) {
  const auto begin = std::chrono::steady_clock::now();
  const double memory_before = memoryFromHere(), before = computing();
  const auto merged = mergeLogs(files);
  const double between = computing();
  if (!merged || !merged->conflicts.empty() || !writeMatchLog(out, merged->rows)) ::_exit(1);
  return {between - before, computing() - between,
          std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
          memory("VmHWM:") - memory_before, static_cast<double>(merged->repeated)};
}

/// In a process of its own, so that the memory of one merge does not hide that of another.
Cost measured(const std::vector<std::string>& files, const std::string& out) {
  const SharedValues<Cost> cost;
  const pid_t child = ::fork();
  if (child == 0) {
    cost[0] = costOf(files, out);
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(status == 0);
  return cost[0];
}

double megabytes(const std::vector<std::string>& files) {
  double bytes = 0;
  for (const std::string& file : files) bytes += static_cast<double>(fs::file_size(file));
  return bytes * 1e-6;
}

}  // namespace

TEST_CASE("shards with failures, retries and duplicates merge to the same bytes", "[soak]") {
  const std::string expected = undisturbed(kMatches);
  std::printf("shards trouble   logs  logs_MB  repeated  read_s  write_s  wall_s  memory_MB\n");
  for (const double trouble : {0.0, 0.2}) {
    for (const std::size_t shards : {1, 10, 100, 1000}) {
      const ScratchFolder scratch(memoryPlace());
      const std::string folder = scratch.path().string();
      const WatchedCalls without_disk(folder);
      const ShardSimulation simulation(folder, kMatches, shards, trouble, static_cast<unsigned>(shards));
      const Cost cost = measured(simulation.files(), folder + "/merged");
      std::printf("%6zu %7.1f %6zu %8.1f %9.0f %7.2f %8.2f %7.2f %10.0f\n", shards, trouble,
                  simulation.files().size(), megabytes(simulation.files()), cost.repeated, cost.read,
                  cost.write, cost.wall, cost.memory);
      CHECK(contentOf(folder + "/merged") == expected);
      CHECK(cost.memory < 100);
      if (shards < 1000 || trouble == 0.0) continue;
      const ShardTroubles& troubles = simulation.troubles();
      std::printf("1000 shards: %zu torn, %zu lost, %zu moved, %zu delivered twice\n", troubles.torn,
                  troubles.lost, troubles.moved, troubles.delivered);
      CHECK(std::min({troubles.torn, troubles.lost, troubles.moved, troubles.delivered}) > 10);
    }
  }
}

}  // namespace fulbito::test
