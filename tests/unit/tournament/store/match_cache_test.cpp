#include "tournament/store/match_cache.hpp"

#include <filesystem>
#include <sys/stat.h>
#include <thread>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/match_rows.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_line.hpp"

namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

struct CacheFolder {
  ScratchFolder scratch;
  std::string folder = (scratch.path() / "a/cache").string();
  MatchCache cache = *MatchCache::open(folder);

  std::string fileOf(const MatchRow& row) const {
    return folder + "/" + row.id.text().substr(0, 2) + "/" + row.id.text() + ".jsonl";
  }
};

std::size_t filesIn(const std::string& folder) {
  std::size_t count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) count += entry.is_regular_file() ? 1 : 0;
  return count;
}

}  // namespace

TEST_CASE("a cache keeps a log of one match per file, by its identity", "[unit]") {
  const CacheFolder c;
  CHECK_FALSE(c.cache.find(matchRow(7).id));
  CHECK(c.cache.add(matchRow(7)) == Added::kNew);
  CHECK(c.cache.add(matchRow(7)) == Added::kSame);
  CHECK(toLine(*c.cache.find(matchRow(7).id)) == toLine(matchRow(7)));
  CHECK(readMatchLog(c.fileOf(matchRow(7)))->size() == 1);
  CHECK(filesIn(c.folder) == 1);
  MatchRow other = matchRow(7);
  other.result.ticks += 1;
  CHECK(c.cache.add(other) == Added::kDifferent);
  CHECK(toLine(*c.cache.find(other.id)) == toLine(matchRow(7)));
}

TEST_CASE("a cache is found again", "[unit]") {
  const CacheFolder c;
  REQUIRE(c.cache.add(matchRow(1)) == Added::kNew);
  CHECK(MatchCache::open(c.folder)->find(matchRow(1).id));
}

TEST_CASE("a damaged or foreign file in a cache counts as missing and is replaced", "[unit]") {
  const CacheFolder c;
  REQUIRE(c.cache.add(matchRow(1)) == Added::kNew);
  const std::string whole = std::string(logHeader()) + toLine(matchRow(1));
  const std::string foreign = std::string(logHeader()) + toLine(matchRow(2));
  for (const std::string& text :
       {std::string(), whole.substr(0, whole.size() - 1), foreign, std::string("x")}) {
    std::ofstream(c.fileOf(matchRow(1)), std::ios::binary) << text;
    CHECK_FALSE(c.cache.find(matchRow(1).id));
    CHECK(c.cache.add(matchRow(1)) == Added::kNew);
    CHECK(c.cache.find(matchRow(1).id));
  }
}

TEST_CASE("what is no file in a cache counts as missing, at once, and makes room where it can", "[unit]") {
  const CacheFolder c;
  const MatchRow row = matchRow(5);
  const std::string file = c.fileOf(row);
  REQUIRE(c.cache.add(row) == Added::kNew);
  for (const bool keeps : {true, false}) {
    for (int kind = 0; kind < 4; ++kind) {
      INFO("kind " << kind);
      fs::remove_all(file);
      if (kind == 0) REQUIRE(::mkfifo(file.c_str(), 0600) == 0);
      if (kind == 1) fs::create_symlink("/dev/zero", file);
      if (kind == 2) fs::create_symlink("nowhere/at/all", file);
      if (kind == 3) fs::create_directories(keeps ? file : file + "/with/content");
      CHECK_FALSE(c.cache.find(row.id));
      CHECK(c.cache.add(row) == Added::kNew);
      CHECK(c.cache.find(row.id).has_value() == (keeps || kind != 3));
    }
  }
  CHECK(fs::exists(file + "/with/content"));
}

TEST_CASE("a cache that cannot be made or written is an error with its name", "[unit]") {
  const ScratchFolder scratch;
  const std::string file = scratch.write("file", "");
  const auto opened = MatchCache::open(file);
  REQUIRE_FALSE(opened);
  CHECK(opened.error().code == ErrorCode::kIo);
  CHECK(opened.error().message.find(file) != std::string::npos);
  const CacheFolder c;
  const std::string part = c.folder + "/" + matchRow(1).id.text().substr(0, 2);
  std::ofstream(part) << "in the way";
  const auto added = c.cache.add(matchRow(1));
  REQUIRE_FALSE(added);
  CHECK(added.error().code == ErrorCode::kIo);
  CHECK(added.error().message.find(part) != std::string::npos);
}

TEST_CASE("threads fill and read one cache", "[unit]") {
  const CacheFolder c;
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) {
    threads.emplace_back([&] {
      for (std::uint64_t i = 0; i < 25; ++i) {
        c.cache.find(matchRow(i).id);
        c.cache.add(matchRow(i));
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(filesIn(c.folder) == 25);
  for (std::uint64_t i = 0; i < 25; ++i) CHECK(toLine(*c.cache.find(matchRow(i).id)) == toLine(matchRow(i)));
}

}  // namespace fulbito::test
