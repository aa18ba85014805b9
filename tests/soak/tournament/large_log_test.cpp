#include <cstdio>
#include <cstdlib>
#include <map>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "engine/core/system/output_file.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/match_rows.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_teams.hpp"
#include "tournament/folder/plan_record.hpp"
#include "tournament/formats/schedule.hpp"
#include "tournament/store/merge.hpp"

namespace fulbito::test {
namespace {

constexpr int kEntrants = 40;
constexpr int kPairs = 64;  // of each of 780 meetings: 99,840 matches

PlanRecord record() {
  TournamentPlan plan;
  plan.match = shortMatch("chaser", "chaser", 300.0);
  plan.pairs = kPairs;
  std::vector<TeamIdentity> identities;
  for (int i = 0; i < kEntrants; ++i) {
    plan.entrants.push_back({"team " + std::to_string(i), *parseTeam("chaser"), {}});
    TeamIdentity identity;
    identity.hash = std::to_string(i);
    identities.push_back(identity);
  }
  return {plan, *MatchIdentity::restore(plan, "engine", std::string(32, '1'), identities)};
}

/// Writes a folder as a finished tournament leaves it.
std::size_t writeFolder(const std::string& folder) {
  const PlanRecord all = record();
  std::map<MatchId, MatchRow> rows;
  std::uint64_t number = 0;
  for (const Fixture& fixture : scheduleOf(all.plan, {}).fixtures) {
    for (std::size_t leg = 0; leg < 2; ++leg) {
      MatchRow row = matchRow(number++);
      row.id = all.identity.of(fixture, leg);
      rows[row.id] = row;
    }
  }
  REQUIRE(prepareFolder(folder));
  REQUIRE(writeFile(folder + "/plan.json", toJson(all)));
  REQUIRE(writeMatchLog(folder + "/matches.jsonl", rows));
  return rows.size();
}

struct Cost {
  int code = -1;
  double computing = 0.0;  ///< [s]
  double memory = 0.0;     ///< [MB] at most
};

/// Runs the program's report into a file.
Cost report(const std::string& folder, const std::string& form, const std::string& out) {
  const pid_t child = ::fork();
  if (child == 0) {
    if (std::freopen("/dev/null", "w", stdout) == nullptr) ::_exit(127);
    ::execl(FULBITO_PROGRAM, FULBITO_PROGRAM, "tournament", "report", folder.c_str(), form.c_str(),
            out.c_str(), nullptr);
    ::_exit(127);
  }
  int status = 0;
  rusage usage{};
  REQUIRE(::wait4(child, &status, 0, &usage) == child);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {WEXITSTATUS(status), seconds(usage.ru_utime) + seconds(usage.ru_stime),
          static_cast<double>(usage.ru_maxrss) * 1024e-6};
}

}  // namespace

TEST_CASE("a report on 100,000 matches takes little memory", "[soak]") {
  const ScratchFolder scratch;
  const std::string folder = (scratch.path() / "results").string();
  CHECK(writeFolder(folder) == 99840);
  std::printf("form        computing [s]  memory [MB]\n");
  for (const std::string form : {"--markdown", "--html", "--csv", "--junit"}) {
    const Cost cost = report(folder, form, (scratch.path() / ("report" + form)).string());
    std::printf("%-12s%13.2f%13.0f\n", form.c_str(), cost.computing, cost.memory);
    CHECK(cost.code == 0);
    CHECK(cost.memory < 200.0);
  }
}

}  // namespace fulbito::test
