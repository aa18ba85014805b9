#include "tournament/store/match_log.hpp"

#include <algorithm>
#include <filesystem>
#include <random>
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

/// The number of matches in a log; negative if reading it fails.
int matchesIn(const std::string& file) {
  const auto rows = readMatchLog(file);
  return rows ? static_cast<int>(rows->size()) : -1;
}

void addAll(MatchStore& log, std::uint64_t begin, std::uint64_t end) {
  for (std::uint64_t i = begin; i < end; ++i) REQUIRE(log.add(matchRow(i)) == Added::kNew);
}

struct LogFolder {
  ScratchFolder scratch{memoryPlace()};
  std::string file = (scratch.path() / "log.jsonl").string();

  void write(const std::string& text) const { scratch.write("log.jsonl", text); }
  /// Opens the log, adds the match `number`, and closes it.
  void addOne(std::uint64_t number) const {
    const auto log = MatchLog::open(file);
    REQUIRE(log);
    REQUIRE((*log)->add(matchRow(number)) == Added::kNew);
  }
};

}  // namespace

TEST_CASE("a store in memory keeps rows and notices differing ones", "[unit]") {
  MatchMemory memory;
  CHECK_FALSE(memory.find(matchRow(1).id));
  CHECK(memory.add(matchRow(1)) == Added::kNew);
  CHECK(memory.add(matchRow(1)) == Added::kSame);
  MatchRow other = matchRow(1);
  other.result.hash += 1;
  CHECK(memory.add(other) == Added::kDifferent);
  CHECK(toLine(*memory.find(other.id)) == toLine(matchRow(1)));
  CHECK(memory.size() == 1);
}

TEST_CASE("all stores give back a row as it will be read", "[unit]") {
  const LogFolder folder;
  MatchRow row = matchRow(1);
  row.result.faults.teams[0].failure = "\xff" + std::string(10000, 'x');
  MatchMemory memory;
  REQUIRE(memory.add(row) == Added::kNew);
  const auto log = MatchLog::open(folder.file);
  REQUIRE((*log)->add(row) == Added::kNew);
  const std::string read = readMatchLog(folder.file)->front().result.faults.teams[0].failure;
  CHECK(memory.find(row.id)->result.faults.teams[0].failure == read);
  CHECK((*log)->find(row.id)->result.faults.teams[0].failure == read);
}

TEST_CASE("a log is a header and a line per match, in the order of adding", "[unit]") {
  const LogFolder folder;
  {
    const auto log = MatchLog::open(folder.file);
    REQUIRE(log);
    CHECK(contentOf(folder.file) == "{\"schema_version\":1,\"content\":\"matches\"}\n");
    addAll(**log, 0, 3);
    CHECK(contentOf(folder.file) == logText(3));  // readable while it is open
  }
  folder.addOne(3);
  CHECK(contentOf(folder.file) == logText(4));
  const auto log = MatchLog::open(folder.file);
  CHECK((*log)->size() == 4);
  CHECK_FALSE((*log)->wasTorn());
  CHECK(toLine(*(*log)->find(matchRow(2).id)) == toLine(matchRow(2)));
  CHECK_FALSE((*log)->find(matchRow(9).id));
}

TEST_CASE("a match that is there is not written again", "[unit]") {
  const LogFolder folder;
  folder.addOne(0);
  const auto log = MatchLog::open(folder.file);
  CHECK((*log)->add(matchRow(0)) == Added::kSame);
  MatchRow other = matchRow(0);
  other.result.score[0] += 1;
  CHECK((*log)->add(other) == Added::kDifferent);
  CHECK(contentOf(folder.file) == logText(1));
}

TEST_CASE("a second writer is refused until the first ends", "[unit]") {
  const LogFolder folder;
  {
    const auto log = MatchLog::open(folder.file);
    const auto second = MatchLog::open(folder.file);
    REQUIRE_FALSE(second);
    CHECK(second.error().code == ErrorCode::kUsage);
    CHECK(second.error().message ==
          "'" + folder.file + "' is being written by another run; wait for its end, or name another file");
    CHECK(matchesIn(folder.file) == 0);  // reading needs no lock
  }
  CHECK(MatchLog::open(folder.file));
}

TEST_CASE("a log that was torn at any byte keeps its whole lines", "[unit]") {
  const LogFolder folder;
  const std::string text = logText(3);
  for (std::size_t size = 0; size <= text.size(); ++size) {
    folder.write(text.substr(0, size));
    const auto lines = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size), '\n');
    const int whole = std::max(0, static_cast<int>(lines) - 1);
    CHECK(matchesIn(folder.file) == whole);
    CHECK(contentOf(folder.file).size() == size);  // reading does not change the file
    continue;                                      // the rest waits for the disk, which takes long
    const auto log = MatchLog::open(folder.file);
    REQUIRE(log);
    CHECK((*log)->size() == static_cast<std::size_t>(whole));
    CHECK((*log)->wasTorn() == (size > 0 && text[size - 1] != '\n'));
    addAll(**log, static_cast<std::uint64_t>(whole), 3);
    CHECK(contentOf(folder.file) == text);
  }
}

TEST_CASE("a last line of zeros or rubbish is cut off too", "[unit]") {
  const LogFolder folder;
  // After a power failure, a file may have its new length before its new bytes.
  for (const std::string& tail :
       {std::string(300, '\0'), std::string(299, '\0') + "\n", std::string("\n"), std::string("{}\n")}) {
    folder.write(logText(2) + tail);
    CHECK(matchesIn(folder.file) == 2);
    folder.addOne(2);
    CHECK(contentOf(folder.file) == logText(3));
  }
}

TEST_CASE("a damaged line in the middle is an error with its place, and changes nothing", "[unit]") {
  const LogFolder folder;
  std::string text = logText(3);
  text[text.find("free-ball:1")] = 'F';
  folder.write(text);
  const std::string expected = folder.file + ":3: the line is damaged: its checksum differs";
  CHECK(readMatchLog(folder.file).error().message == expected);
  const auto log = MatchLog::open(folder.file);
  REQUIRE_FALSE(log);
  CHECK(log.error().code == ErrorCode::kBadInput);
  CHECK(log.error().message == expected);
  CHECK(contentOf(folder.file) == text);
}

TEST_CASE("a match with two results in a log is an error with its place", "[unit]") {
  const LogFolder folder;
  MatchRow other = matchRow(0);
  other.result.hash += 1;
  folder.write(logText(2) + toLine(matchRow(1)) + toLine(other));
  const std::string expected =
      folder.file + ":5: match " + other.id.text() + " is there twice, with different results";
  CHECK(readMatchLog(folder.file).error().message == expected);
  CHECK(MatchLog::open(folder.file).error().message == expected);
}

TEST_CASE("logs may be joined, and a repeated match counts once", "[unit]") {
  const LogFolder folder;
  folder.write(logText(2) + logText(3));
  CHECK(matchesIn(folder.file) == 3);
}

TEST_CASE("a file that is no log is refused and stays as it is", "[unit]") {
  const LogFolder folder;
  const std::string right(logHeader());
  std::string newer = right;
  newer.replace(newer.find(":1"), 2, ":2");
  for (const std::string& text :
       {std::string("x"), std::string("notes\n"), std::string("\n"), newer, "{" + right, toLine(matchRow(1)),
        std::string(2 * kLongestLine, 'x'), std::string(10, '\0')}) {
    folder.write(text);
    const auto log = MatchLog::open(folder.file);
    REQUIRE_FALSE(log);
    CHECK(log.error().code == ErrorCode::kBadInput);
    CHECK(log.error().message.starts_with(folder.file + ":1: "));
    CHECK(readMatchLog(folder.file).error().message == log.error().message);
    CHECK(contentOf(folder.file) == text);
  }
}

TEST_CASE("a missing log is empty only where it may be missing", "[unit]") {
  const LogFolder folder;
  CHECK(readMatchLog(folder.file, true)->empty());
  CHECK((*readMatchStore(folder.file, true))->size() == 0);
  const auto rows = readMatchLog(folder.file);
  REQUIRE_FALSE(rows);
  CHECK(rows.error().code == ErrorCode::kIo);
  CHECK(rows.error().message == "cannot read '" + folder.file + "': No such file or directory");
}

TEST_CASE("a log that is open can be read", "[unit]") {
  const LogFolder folder;
  const auto log = MatchLog::open(folder.file);
  addAll(**log, 0, 5);
  const auto store = readMatchStore(folder.file);
  CHECK((*store)->size() == 5);
  CHECK((*store)->find(matchRow(4).id));
}

TEST_CASE("threads add to one log", "[unit]") {
  const LogFolder folder;
  {
    const auto log = MatchLog::open(folder.file);
    std::vector<std::thread> threads;
    for (std::uint64_t t = 0; t < 4; ++t) {
      threads.emplace_back([&, t] {
        for (std::uint64_t i = 0; i < 50; ++i) {
          (*log)->add(matchRow(i / 2 + 25 * t));  // adds each match twice, while others search
          (*log)->find(matchRow(i).id);
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    CHECK((*log)->size() == 100);
  }
  CHECK(matchesIn(folder.file) == 100);
  const std::string text = contentOf(folder.file);
  CHECK(std::count(text.begin(), text.end(), '\n') == 101);
}

TEST_CASE("a log that another program removes, replaces or changes gets no more matches", "[unit]") {
  const LogFolder folder;
  const auto after = [&](const std::string& problem, const auto& harm) {
    fs::remove(folder.file);
    const auto log = MatchLog::open(folder.file);
    addAll(**log, 0, 2);
    harm();
    const auto added = (*log)->add(matchRow(2));
    REQUIRE_FALSE(added);
    CHECK(added.error().code == ErrorCode::kIo);
    CHECK(added.error().message == "cannot write '" + folder.file + "': " + problem);
    CHECK((*log)->add(matchRow(3)).error().message == added.error().message);
    CHECK((*log)->add(matchRow(1)) == Added::kSame);
    CHECK((*log)->size() == 2);
  };
  after("No such file or directory", [&] { fs::remove(folder.file); });
  after("another program replaced it", [&] {
    fs::remove(folder.file);
    folder.write("new");
  });
  CHECK(contentOf(folder.file) == "new");
  after("another program changed it", [&] { std::ofstream(folder.file, std::ios::app) << "tail"; });
  CHECK(contentOf(folder.file) == logText(2) + "tail");
}

TEST_CASE("a link to a log is followed", "[unit]") {
  const LogFolder folder;
  fs::create_directory(folder.scratch.path() / "far");
  fs::create_symlink("far/log", folder.file);
  folder.addOne(0);
  CHECK(fs::is_symlink(folder.file));
  CHECK(contentOf((folder.scratch.path() / "far/log").string()) == logText(1));
}

}  // namespace fulbito::test
