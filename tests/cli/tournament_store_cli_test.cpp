#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_log.hpp"
#include "tournament/store/merge.hpp"

namespace fulbito::test {
namespace {

constexpr const char* kRun = "tournament run idle chaser --pairs 2 --half-seconds 2 --jobs 1 --out ";

std::string logOf(const Sandbox& sandbox, const std::string& folder) {
  return (sandbox.path / folder / "matches.jsonl").string();
}

}  // namespace

TEST_CASE("a merge of shards with another result of one match exits with 7 and writes nothing", "[cli]") {
  const Sandbox sandbox;
  sandbox.works(std::string(kRun) + "a --shard 1/2");
  sandbox.works(std::string(kRun) + "b --shard 2/2");
  sandbox.works(std::string(kRun) + "c --shard 1/2");
  CHECK(sandbox.run("tournament merge a b c --out good").code == 0);
  auto rows = mergeLogs({logOf(sandbox, "c")})->rows;
  rows.begin()->second.result.hash ^= 1;
  REQUIRE(writeMatchLog(logOf(sandbox, "c"), rows));
  const Output merged = sandbox.run("tournament merge a b c --out bad");
  CHECK(merged.code == 7);
  CHECK(contains(merged.err, "two runs of one match differ"));
  CHECK(contains(merged.err, "c/matches.jsonl"));
  CHECK_FALSE(fs::exists(sandbox.path / "bad"));
}

TEST_CASE("a log that another run writes is a wrong use, and a damaged one bad input", "[cli]") {
  const Sandbox sandbox;
  sandbox.works(std::string(kRun) + "out");
  {
    const auto held = MatchLog::open(logOf(sandbox, "out"));
    sandbox.fails(std::string(kRun) + "out", 2, "is being written by another run");
    CHECK(sandbox.run("tournament report out").code == 0);  // reading needs no lock
  }
  std::string text = contentOf(logOf(sandbox, "out"));
  text[text.find("\"score\"") + 9] ^= 1;
  std::ofstream(logOf(sandbox, "out"), std::ios::binary) << text;
  for (const std::string& command : {std::string(kRun) + "out", std::string("tournament report out")}) {
    sandbox.fails(command, 3, "out/matches.jsonl:2: the line is damaged");
  }
  CHECK(contentOf(logOf(sandbox, "out")) == text);
}

TEST_CASE("a folder of results that cannot be written exits with 5", "[cli]") {
  const Sandbox sandbox;
  sandbox.write("file", "");
  fs::create_directories(sandbox.path / "folder" / "matches.jsonl");
  fs::create_symlink("loop", sandbox.path / "loop");
  for (const std::string name : {"file", "file/out", "folder", "loop", "/dev/full", "/proc/out"}) {
    INFO(name);
    sandbox.fails(kRun + name, 5, name);
  }
  const Output limited =
      sandbox.shell("ulimit -f 24; \"$F\" tournament run idle chaser --pairs 100 --half-seconds 1 --out out");
  CHECK(limited.code == 5);
  CHECK(contains(limited.err, "out/matches.jsonl': File too large"));
  const auto kept = readMatchLog(logOf(sandbox, "out"));
  REQUIRE(kept);
  CHECK(kept->size() > 0);
}

}  // namespace fulbito::test
