#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <map>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/match_rows.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/shared_values.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_line.hpp"
#include "tournament/store/match_log.hpp"

namespace fulbito::test {
namespace {

constexpr int kKills = 500;
constexpr std::uint64_t kRows = 60;
constexpr std::chrono::microseconds kLongestLife(60000);

/// What a tournament does: takes what is there, adds the rest, and knows of each match that it is kept.
int fill(const std::string& file, std::uint64_t& kept) {
  const auto log = MatchLog::open(file);
  if (!log) return 1;
  for (std::uint64_t i = 0; i < kRows; ++i) {
    if (!(*log)->find(matchRow(i).id) && (*log)->add(matchRow(i)) != Added::kNew) return 2;
    kept = std::max(kept, i + 1);
  }
  return 0;
}

/// Runs `fill` in a process of its own for at most this time. @return whether it was killed
bool fillUntil(std::chrono::microseconds life, const std::string& file, std::uint64_t& kept) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(fill(file, kept));
  std::this_thread::sleep_for(life);
  ::kill(child, SIGKILL);
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  if (WIFEXITED(status)) REQUIRE(WEXITSTATUS(status) == 0);
  return WIFSIGNALED(status);
}

/// What a log lost or doubled, against what the writer was told.
struct Harm {
  std::size_t lost = 0, doubled = 0;
};

Harm harmIn(const std::string& file, std::uint64_t kept) {
  Harm harm;
  std::map<MatchId, int> times;
  const auto end = readRows(file, true, [&](const MatchRow& row, std::size_t) {
    harm.doubled += ++times[row.id] == 2 ? 1 : 0;
    return Result<void>();
  });
  REQUIRE(end);
  for (std::uint64_t i = 0; i < kept; ++i) harm.lost += times.contains(matchRow(i).id) ? 0 : 1;
  return harm;
}

}  // namespace

TEST_CASE("kill -9 at random moments loses and doubles no match", "[soak]") {
  const ScratchFolder scratch;  // on a disk, where a sync takes its time
  const std::string file = (scratch.path() / "log.jsonl").string();
  const SharedValues<std::uint64_t> kept;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> lives(0, static_cast<int>(kLongestLife.count()));
  Harm harm;
  int kills = 0, logs = 0, torn = 0;
  while (kills < kKills) {
    const bool killed = fillUntil(std::chrono::microseconds(lives(random)), file, kept[0]);
    const Harm now = harmIn(file, kept[0]);
    harm = {harm.lost + now.lost, harm.doubled + now.doubled};
    kills += killed ? 1 : 0;
    torn += killed && !contentOf(file).ends_with('\n') ? 1 : 0;
    if (killed) continue;
    CHECK(contentOf(file) == logText(kRows));
    ++logs;
    kept[0] = 0;
    std::filesystem::remove(file);
  }
  std::printf(
      "%d kills, %d logs completed, %d left without a whole last line: %zu matches lost, %zu doubled\n",
      kills, logs, torn, harm.lost, harm.doubled);
  CHECK(logs > 0);
  CHECK(harm.lost == 0);
  CHECK(harm.doubled == 0);
}

}  // namespace fulbito::test
