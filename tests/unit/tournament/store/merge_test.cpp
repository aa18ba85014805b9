#include "tournament/store/merge.hpp"

#include <algorithm>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/match_rows.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/shard_simulation.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_line.hpp"

namespace fulbito::test {
namespace {

std::string logOf(const std::vector<MatchRow>& rows) {
  std::string text(logHeader());
  for (const MatchRow& row : rows) text += toLine(row);
  return text;
}

/// The bytes of the log that merges these files.
std::string mergedText(const ScratchFolder& scratch, const std::vector<std::string>& files) {
  const std::string out = (scratch.path() / "merged.jsonl").string();
  const auto merged = mergeLogs(files);
  REQUIRE(merged);
  REQUIRE(writeMatchLog(out, merged->rows));
  return contentOf(out);
}

}  // namespace

TEST_CASE("a merge is the union by identity and counts repeats", "[unit]") {
  const ScratchFolder scratch;
  const std::string a = scratch.write("a", logOf({matchRow(1), matchRow(2)}));
  const std::string b = scratch.write("b", logOf({matchRow(3), matchRow(2), matchRow(2)}) + "torn");
  const auto merged = mergeLogs({a, b, a});
  REQUIRE(merged);
  CHECK(merged->rows.size() == 3);
  CHECK(merged->repeated == 4);
  CHECK(merged->torn == 1);
  CHECK(merged->conflicts.empty());
  for (std::uint64_t i : {1, 2, 3}) CHECK(toLine(merged->rows.at(matchRow(i).id)) == toLine(matchRow(i)));
  CHECK(mergeLogs({})->rows.empty());
}

TEST_CASE("runs of one match that differ are listed with their files", "[unit]") {
  const ScratchFolder scratch;
  MatchRow other = matchRow(2), third = matchRow(2);
  other.result.hash += 1;
  third.result.score[0] += 1;
  const std::string a = scratch.write("a", logOf({matchRow(1)}));
  const std::string b = scratch.write("b", logOf({matchRow(1), matchRow(2)}));
  const std::string c = scratch.write("c", logOf({other, third, matchRow(2)}));
  const auto merged = mergeLogs({a, b, c});
  REQUIRE(merged);
  REQUIRE(merged->conflicts.size() == 2);
  CHECK(merged->conflicts[0].first_file == b);
  CHECK(merged->conflicts[0].second_file == c);
  CHECK(toLine(merged->conflicts[0].first) == toLine(matchRow(2)));
  CHECK(toLine(merged->conflicts[0].second) == toLine(other));
  CHECK(toLine(merged->conflicts[1].second) == toLine(third));
  CHECK(merged->repeated == 2);
}

TEST_CASE("a merged log has the same bytes for any order of its logs", "[unit]") {
  const ScratchFolder scratch;
  MatchRow words = matchRow(2);  // the same result with other texts is not a conflict
  words.result.faults.teams[0].failure = "process 4711 was killed";
  words.teams[0] = "another name";
  std::vector<std::string> files = {scratch.write("a", logOf({matchRow(1), matchRow(2)})),
                                    scratch.write("b", logOf({matchRow(4), words})),
                                    scratch.write("c", logOf({matchRow(3)}))};
  const std::string text = mergedText(scratch, files);
  CHECK(std::count(text.begin(), text.end(), '\n') == 5);
  do {
    CHECK(mergedText(scratch, files) == text);
  } while (std::next_permutation(files.begin(), files.end()));
}

TEST_CASE("a merged log is ordered by identity, and merging it again changes nothing", "[unit]") {
  const ScratchFolder scratch;
  std::vector<MatchRow> rows;
  for (std::uint64_t i = 0; i < 2000; ++i) rows.push_back(matchRow(i));
  const std::string a = scratch.write("a", logOf(rows));
  const std::string text = mergedText(scratch, {a});
  std::sort(rows.begin(), rows.end(), [](const MatchRow& x, const MatchRow& y) { return x.id < y.id; });
  CHECK(text == logOf(rows));
  CHECK(mergedText(scratch, {(scratch.path() / "merged.jsonl").string(), a}) == text);
  CHECK(readMatchLog((scratch.path() / "merged.jsonl").string())->size() == 2000);
}

TEST_CASE("a missing or damaged log ends a merge with its name", "[unit]") {
  const ScratchFolder scratch;
  const std::string a = scratch.write("a", logOf({matchRow(1)}));
  const auto missing = mergeLogs({a, a + "x"});
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == ErrorCode::kIo);
  CHECK(missing.error().message.find(a + "x") != std::string::npos);
  const std::string b = scratch.write("b", "notes\n");
  CHECK(mergeLogs({a, b}).error().message.starts_with(b + ":1: "));
}

TEST_CASE("shards with failures, retries and duplicates merge to the same bytes", "[unit]") {
  constexpr std::uint64_t kMatches = 2000;
  std::vector<MatchRow> rows;
  for (std::uint64_t i = 0; i < kMatches; ++i) rows.push_back(matchRow(i));
  std::sort(rows.begin(), rows.end(), [](const MatchRow& x, const MatchRow& y) { return x.id < y.id; });
  const std::string expected = logOf(rows);
  for (const std::size_t shards : {1, 3, 7, 50}) {
    INFO(shards);
    const ScratchFolder scratch(memoryPlace());
    const ShardSimulation simulation(scratch.path().string(), kMatches, shards, 0.3,
                                     static_cast<unsigned>(shards));
    CHECK(simulation.files().size() >= shards);
    CHECK(mergedText(scratch, simulation.files()) == expected);
    if (shards == 50) CHECK(simulation.troubles().torn > 0);
    if (shards == 50) CHECK(simulation.troubles().moved > 0);
  }
}

}  // namespace fulbito::test
