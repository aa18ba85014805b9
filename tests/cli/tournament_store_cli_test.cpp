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
  REQUIRE(sandbox.run(std::string(kRun) + "a --shard 1/2").code == 0);
  REQUIRE(sandbox.run(std::string(kRun) + "b --shard 2/2").code == 0);
  REQUIRE(sandbox.run(std::string(kRun) + "c --shard 1/2").code == 0);
  CHECK(sandbox.run("tournament merge a b c --out good").code == 0);
  auto rows = mergeLogs({logOf(sandbox, "c")})->rows;
  rows.begin()->second.result.hash ^= 1;
  REQUIRE(writeMatchLog(logOf(sandbox, "c"), rows));
  const Output merged = sandbox.run("tournament merge a b c --out bad");
  CHECK(merged.code == 7);
  CHECK(merged.err.find("two runs of one match differ") != std::string::npos);
  CHECK(merged.err.find("c/matches.jsonl") != std::string::npos);
  CHECK_FALSE(fs::exists(sandbox.path / "bad"));
}

TEST_CASE("a log that another run writes is a wrong use, and a damaged one bad input", "[cli]") {
  const Sandbox sandbox;
  REQUIRE(sandbox.run(std::string(kRun) + "out").code == 0);
  {
    const auto held = MatchLog::open(logOf(sandbox, "out"));
    const Output second = sandbox.run(std::string(kRun) + "out");
    CHECK(second.code == 2);
    CHECK(second.err.find("is being written by another run") != std::string::npos);
    CHECK(sandbox.run("tournament report out").code == 0);  // reading needs no lock
  }
  std::string text = contentOf(logOf(sandbox, "out"));
  text[text.find("\"score\"") + 9] ^= 1;
  std::ofstream(logOf(sandbox, "out"), std::ios::binary) << text;
  for (const std::string& command : {std::string(kRun) + "out", std::string("tournament report out")}) {
    const Output damaged = sandbox.run(command);
    CHECK(damaged.code == 3);
    CHECK(damaged.err.find("out/matches.jsonl:2: the line is damaged") != std::string::npos);
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
    const Output output = sandbox.run(kRun + name);
    CHECK(output.code == 5);
    CHECK(output.err.find(name) != std::string::npos);
  }
  const Output limited =
      sandbox.shell("ulimit -f 24; \"$F\" tournament run idle chaser --pairs 100 --half-seconds 1 --out out");
  CHECK(limited.code == 5);
  CHECK(limited.err.find("out/matches.jsonl': File too large") != std::string::npos);
  const auto kept = readMatchLog(logOf(sandbox, "out"));
  REQUIRE(kept);
  CHECK(kept->size() > 0);
}

}  // namespace fulbito::test
