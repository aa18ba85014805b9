#include "tournament/folder/results_folder.hpp"

#include <algorithm>
#include <filesystem>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_teams.hpp"
#include "tournament/store/log_reader.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

PlanRecord recordOf(int pairs, const std::string& sources = "one") {
  TournamentPlan plan;
  plan.entrants = {{"chaser", *parseTeam("chaser"), {}},
                   {"idle", *parseTeam("idle"), {}},
                   {"random", *parseTeam("random"), {}}};
  plan.pairs = pairs;
  plan.match = shortMatch("chaser", "chaser", 2.0);
  std::vector<TeamIdentity> teams(3);
  for (std::size_t i = 0; i < teams.size(); ++i) teams[i].hash = plan.entrants[i].name + sources;
  return {plan, *MatchIdentity::restore(plan, "engine", "00000000000000000000000000000001", teams)};
}

std::string in(const ScratchFolder& scratch, const std::string& name) {
  return (scratch.path() / name).string();
}

RunOutcome runIn(const std::string& path, const PlanRecord& record, Shard shard = {}) {
  auto folder = openResultsFolder(path, record);
  REQUIRE(folder);
  RunnerOptions options;
  options.jobs = 2;
  options.log = folder->log.get();
  options.shard = shard;
  auto played = runTournament(record.plan, record.identity, options);
  REQUIRE(played);
  return std::move(*played);
}

std::vector<std::uint64_t> hashesOf(const TournamentState& state) {
  std::vector<std::uint64_t> hashes;
  for (const auto& pair : state.results) {
    for (std::size_t leg = 0; leg < 2; ++leg) hashes.push_back(pair ? pair->legs[leg].hash : 0);
  }
  return hashes;
}

}  // namespace

TEST_CASE("a folder continues its tournament and can be read without its teams", "[unit]") {
  const ScratchFolder scratch;
  const std::string path = in(scratch, "results");
  const PlanRecord record = recordOf(1);
  const RunOutcome first = runIn(path, record);
  CHECK(first.played == 6);
  const RunOutcome second = runIn(path, record);
  CHECK(second.played == 0);
  CHECK(second.taken == 6);
  const auto read = readFolder(path);
  REQUIRE(read);
  CHECK(read->state.finished());
  CHECK(hashesOf(read->state) == hashesOf(first.state));
}

TEST_CASE("a folder of another plan is refused, with what differs", "[unit]") {
  const ScratchFolder scratch;
  runIn(in(scratch, "results"), recordOf(1));
  const auto other = openResultsFolder(in(scratch, "results"), recordOf(2));
  REQUIRE_FALSE(other);
  CHECK(other.error().code == ErrorCode::kUsage);
  CHECK(other.error().message.find("pairs: 1 -> 2") != std::string::npos);
}

TEST_CASE("a folder that keeps a tuning takes no tournament", "[unit]") {
  const ScratchFolder scratch;
  scratch.write("results/tune.json", "{}");
  runIn(in(scratch, "whole"), recordOf(1));
  for (const std::string& text :
       {openResultsFolder(in(scratch, "results"), recordOf(1)).error().message,
        mergeFolders({in(scratch, "whole")}, in(scratch, "results")).error().message}) {
    CHECK(text == in(scratch, "results") + " holds a tuning; name another folder");
  }
  CHECK_FALSE(std::filesystem::exists(scratch.path() / "results/plan.json"));
}

TEST_CASE("matches of a team that has changed are played again", "[unit]") {
  const ScratchFolder scratch;
  runIn(in(scratch, "results"), recordOf(1));
  PlanRecord record = recordOf(1);
  std::vector<TeamIdentity> teams = record.identity.teams();
  teams[2].hash = "two";
  record.identity = *MatchIdentity::restore(record.plan, "engine", "00000000000000000000000000000001", teams);
  {
    const auto folder = openResultsFolder(in(scratch, "results"), record);
    REQUIRE(folder);
    CHECK(folder->changed == std::vector<std::string>{"random has changed"});
  }
  const RunOutcome again = runIn(in(scratch, "results"), record);
  CHECK(again.played == 4);
  CHECK(again.taken == 2);
}

TEST_CASE("shards in folders of their own merge to the whole, in any order and number", "[unit]") {
  const ScratchFolder scratch;
  const PlanRecord record = recordOf(2);
  const RunOutcome whole = runIn(in(scratch, "whole"), record);
  for (const std::size_t count : {1, 3, 7}) {
    std::vector<std::string> folders;
    for (std::size_t i = 0; i < count; ++i) {
      folders.push_back(in(scratch, (std::to_string(count) + "-" + std::to_string(i))));
      runIn(folders.back(), record, {i, count});
    }
    const std::string into = in(scratch, ("merged-" + std::to_string(count)));
    std::reverse(folders.begin(), folders.end());
    const auto merged = mergeFolders(folders, into);
    REQUIRE(merged);
    CHECK(merged->matches == 12);
    const auto read = readFolder(into);
    REQUIRE(read);
    CHECK(read->state.finished());
    CHECK(hashesOf(read->state) == hashesOf(whole.state));
    REQUIRE(mergeFolders(folders, into));  // merging again into the same folder changes nothing
  }
}

TEST_CASE("shards of other plans or teams are refused, and runs that differ are shown", "[unit]") {
  const ScratchFolder scratch;
  runIn(in(scratch, "a"), recordOf(1));
  runIn(in(scratch, "b"), recordOf(2));
  runIn(in(scratch, "c"), recordOf(1, "two"));
  CHECK(mergeFolders({in(scratch, "a"), in(scratch, "b")}, in(scratch, "x")).error().code ==
        ErrorCode::kUsage);
  const auto changed = mergeFolders({in(scratch, "a"), in(scratch, "c")}, in(scratch, "x"));
  REQUIRE_FALSE(changed);
  CHECK(changed.error().message.find("chaser has changed") != std::string::npos);
  CHECK_FALSE(mergeFolders({in(scratch, "missing")}, in(scratch, "x")));

  const PlanRecord record = recordOf(1);
  {
    const auto folder = openResultsFolder(in(scratch, "d"), record);
    REQUIRE(folder);
    const auto rows = readMatchStore(in(scratch, "a") + "/matches.jsonl");
    REQUIRE(rows);
    auto row = (*rows)->find(record.identity.of({0, 1, 0, 0}, 0));
    REQUIRE(row);
    ++row->result.hash;
    REQUIRE(folder->log->add(*row));
  }
  const auto merged = mergeFolders({in(scratch, "a"), in(scratch, "d")}, in(scratch, "y"));
  REQUIRE(merged);
  REQUIRE(merged->conflicts.size() == 1);
  CHECK_FALSE(readFolder(in(scratch, "y")));
}

}  // namespace fulbito
