#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "engine/core/system/io_code.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/match_rows.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/shared_values.hpp"
#include "tests/support/watched_calls.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_cache.hpp"
#include "tournament/store/match_line.hpp"
#include "tournament/store/match_log.hpp"
#include "tournament/store/merge.hpp"

// Lets every call on a file fail, one after the other, in every way that the kernel can; and lets the process
// die at every call.
namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kRows = 20;
constexpr std::uint64_t kMergedRows = 900;  // more than one block of writing

/// A piece of work that writes files in its own folder, and can be repeated after a failure.
struct Work {
  const char* name;
  /// Creates the files that exist before the work.
  std::function<void(const std::string& folder)> prepare;
  /// Adds the number of rows that are certainly stored to `kept`. Errors: those of the store.
  std::function<Result<void>(const std::string& folder, std::uint64_t& kept)> run;
  /// Fails the test unless at least `kept` rows exist and nothing is damaged.
  std::function<void(const std::string& folder, std::uint64_t kept)> check;
  /// Calls whose failure has no effect on the result.
  std::vector<Call> harmless;
};

Result<void> addTo(const std::function<Result<Added>(const MatchRow&)>& add, std::uint64_t& kept) {
  for (std::uint64_t i = 0; i < kRows; ++i) {
    const auto added = add(matchRow(i));
    if (!added) return tl::unexpected<Error>(added.error());
    REQUIRE(added != Added::kDifferent);
    kept = i + 1;
  }
  return {};
}

Result<void> fillLog(const std::string& folder, std::uint64_t& kept) {
  const auto log = MatchLog::open(folder + "/log");
  if (!log) return tl::unexpected<Error>(log.error());
  auto done = addTo([&](const MatchRow& row) { return (*log)->add(row); }, kept);
  if (done) return done;
  // The log stays failed, and the rows that it stored can still be found.
  CHECK((*log)->add(matchRow(kept)).error().message == done.error().message);
  for (std::uint64_t i = 0; i < kept; ++i) CHECK((*log)->find(matchRow(i).id));
  CHECK_FALSE((*log)->find(matchRow(kept).id));
  return done;
}

void checkLog(const std::string& folder, std::uint64_t kept) {
  const auto rows = readMatchLog(folder + "/log", true);
  REQUIRE(rows);
  CHECK(rows->size() >= kept);
  // All whole lines equal those of an undisturbed run, in the same order.
  CHECK(logText(kRows).starts_with(contentOf(folder + "/log")));
}

Result<void> fillCache(const std::string& folder, std::uint64_t& kept) {
  const auto cache = MatchCache::open(folder + "/cache");
  if (!cache) return tl::unexpected<Error>(cache.error());
  return addTo([&](const MatchRow& row) { return cache->add(row); }, kept);
}

void checkCache(const std::string& folder, std::uint64_t kept) {
  const auto cache = MatchCache::open(folder + "/cache");
  REQUIRE(cache);
  for (std::uint64_t i = 0; i < kRows; ++i) {
    const auto row = cache->find(matchRow(i).id);
    CHECK((row || i >= kept));
    if (row) CHECK(toLine(*row) == toLine(matchRow(i)));
  }
}

Result<void> merge(const std::string& folder, std::uint64_t& kept) {
  const auto merged = mergeLogs({folder + "/in"});
  if (!merged) return tl::unexpected<Error>(merged.error());
  auto written = writeMatchLog(folder + "/out", merged->rows);
  if (written) kept = kMergedRows;
  return written;
}

/// Checks that the output is either the old file or the new one, complete.
void checkMerged(const std::string& folder, std::uint64_t kept) {
  const auto rows = readMatchLog(folder + "/out");
  REQUIRE(rows);
  CHECK((rows->size() == kMergedRows || (kept == 0 && rows->size() == 1)));
}

void nothing(const std::string&) {}

void writeFileAt(const std::string& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

std::vector<Work> works() {
  const auto torn_log = [](const std::string& folder) {
    const std::string text = logText(kRows / 2);
    writeFileAt(folder + "/log", text.substr(0, text.size() - 9));
  };
  const auto old_merge = [](const std::string& folder) {
    writeFileAt(folder + "/in", logText(kMergedRows));
    writeFileAt(folder + "/out", logText(1));
  };
  return {{"a new log", nothing, fillLog, checkLog, {}},
          {"a torn log", torn_log, fillLog, checkLog, {}},
          {"a cache", nothing, fillCache, checkCache, {Call::kRead, Call::kOpen}},
          {"a merge", old_merge, merge, checkMerged, {}}};
}

struct WorkFolder {
  explicit WorkFolder(const Work& w) : work(w) { work.prepare(path); }
  ScratchFolder scratch{memoryPlace()};
  std::string path = scratch.path().string();
  const Work& work;

  bool hasTemporary() const {
    const auto files = fs::recursive_directory_iterator(path);
    return std::any_of(begin(files), end(files),
                       [](const auto& f) { return f.path().extension() == ".tmp"; });
  }
  /// Checks that the work completes with the same files as an undisturbed run.
  void checkCompletes() const {
    std::uint64_t kept = 0;
    REQUIRE(work.run(path, kept));
    work.check(path, kept);
    CHECK(kept >= kRows);
  }
};

/// The number of times that an undisturbed run makes each call.
std::array<int, std::size(kCalls)> callsOf(const Work& work) {
  const WorkFolder folder(work);
  const WatchedCalls watched(folder.path);
  std::uint64_t kept = 0;
  REQUIRE(work.run(folder.path, kept));
  std::array<int, std::size(kCalls)> counts{};
  for (const Call call : kCalls) counts[static_cast<std::size_t>(call)] = watched.count(call);
  return counts;
}

/// The errors with which a kind of call can fail on Linux.
std::vector<int> errorsOf(Call call) {
  static const std::map<Call, std::vector<int>> errors = {{Call::kOpen, {EACCES, EMFILE, ENOSPC, EIO, EINTR}},
                                                          {Call::kRead, {EIO, EINTR}},
                                                          {Call::kWrite, {ENOSPC, EDQUOT, EIO, EFBIG, EINTR}},
                                                          {Call::kSync, {EIO, ENOSPC, EDQUOT}},
                                                          {Call::kRename, {EIO, ENOSPC, EACCES, EROFS}},
                                                          {Call::kTruncate, {EIO, EINTR}},
                                                          {Call::kLock, {ENOLCK, EINTR}},
                                                          {Call::kFolder, {ENOSPC, EROFS, EACCES}}};
  return errors.at(call);
}

std::vector<Fault> faultsOf(Call call, int nth) {
  std::vector<Fault> faults;
  for (const int error : errorsOf(call)) {
    for (const bool half : {false, true}) {
      for (const bool lasting : {false, true}) {
        if (half && call != Call::kWrite) continue;
        if (lasting && error == EINTR) continue;  // this would be an endless series of signals
        faults.push_back({call, nth, error, half, lasting});
      }
    }
  }
  return faults;
}

/// All single faults of a piece of work.
std::vector<Fault> faultsOf(const Work& work) {
  std::vector<Fault> all;
  const auto counts = callsOf(work);
  for (const Call call : kCalls) {
    for (int nth = 1; nth <= counts[static_cast<std::size_t>(call)]; ++nth) {
      for (const Fault& fault : faultsOf(call, nth)) all.push_back(fault);
    }
  }
  return all;
}

std::string textOf(const Work& work, const Fault& fault) {
  return fmt::format("{}: {} {} with {}{}{}", work.name, nameOf(fault.call), fault.nth, fault.error,
                     fault.half ? " after half" : "", fault.lasting ? ", lasting" : "");
}

void checkFault(const Work& work, const Fault& fault) {
  INFO(textOf(work, fault));
  const WorkFolder folder(work);
  std::uint64_t kept = 0;
  Result<void> done;
  {
    const WatchedCalls watched(folder.path, {fault});
    done = work.run(folder.path, kept);
    REQUIRE(watched.count(fault.call) >= fault.nth);
  }
  const bool harmless =
      fault.error == EINTR || std::count(work.harmless.begin(), work.harmless.end(), fault.call) > 0;
  CHECK((harmless || !done));
  CHECK((fault.error != EINTR || done));
  if (!done) {
    CHECK(done.error().code == ioCode(fault.error));
    CHECK(done.error().message.find(folder.path) != std::string::npos);
  }
  CHECK_FALSE(folder.hasTemporary());
  work.check(folder.path, kept);
  folder.checkCompletes();
}

/// Forks a child that does the work and dies at the fault.
void dieAt(const WorkFolder& folder, const Fault& fault, const SharedValues<std::uint64_t>& kept) {
  const pid_t child = ::fork();
  if (child == 0) {
    try {
      const WatchedCalls watched(folder.path, {fault});
      (void)folder.work.run(folder.path, kept[0]);
    } catch (...) {
      ::_exit(1);
    }
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  REQUIRE(WIFSIGNALED(status));
  REQUIRE(WTERMSIG(status) == SIGKILL);
}

void checkDeath(const Work& work, const Fault& fault) {
  INFO(textOf(work, fault));
  const WorkFolder folder(work);
  const SharedValues<std::uint64_t> kept;
  dieAt(folder, fault, kept);
  work.check(folder.path, kept[0]);
  folder.checkCompletes();
}

}  // namespace

TEST_CASE("any failing call is an error that names the file, and loses nothing", "[unit]") {
  std::map<Call, int> injected;
  for (const Work& work : works()) {
    for (const Fault& fault : faultsOf(work)) {
      checkFault(work, fault);
      ++injected[fault.call];
    }
  }
  int all = 0;
  for (const auto& [call, count] : injected) all += count;
  const int bar = injected[Call::kWrite] + injected[Call::kSync] + injected[Call::kRename];
  std::printf("%d injected failures, of them %d of write, sync and rename\n", all, bar);
  CHECK(bar >= 1000);
}

TEST_CASE("a process that dies at any call loses nothing that was kept", "[unit]") {
  for (const Work& work : works()) {
    const auto counts = callsOf(work);
    for (const Call call : kCalls) {
      // After half a write, the process dies at the next call, which would continue the write.
      for (int nth = 1; nth <= counts[static_cast<std::size_t>(call)]; ++nth) {
        checkDeath(work, {call, nth});
        if (call == Call::kWrite) checkDeath(work, {call, nth, 0, true});
      }
    }
  }
}

TEST_CASE("a line that cannot even be cut off is cut by the next run", "[unit]") {
  const Work log = works().front();
  for (const int nth : {1, 2, 12}) {
    const WorkFolder folder(log);
    std::uint64_t kept = 0;
    {
      const WatchedCalls watched(
          folder.path, {{Call::kWrite, nth, ENOSPC, true, true}, {Call::kTruncate, 2, EIO, false, true}});
      const auto done = log.run(folder.path, kept);
      REQUIRE_FALSE(done);
      CHECK(done.error().message == "cannot write '" + folder.path + "/log': No space left on device");
    }
    const std::string text = contentOf(folder.path + "/log");
    CHECK_FALSE(text.ends_with('\n'));
    log.check(folder.path, kept);
    folder.checkCompletes();
    CHECK(contentOf(folder.path + "/log") == logText(kRows));
  }
}

TEST_CASE("each match is one write and one sync, and a new log's name is synced too", "[unit]") {
  const ScratchFolder scratch;
  const std::string folder = scratch.path().string();
  std::uint64_t kept = 0;
  const WatchedCalls watched(folder);
  REQUIRE(fillLog(folder, kept));
  std::vector<std::string> expected = {"open log", "lock log", "read log",  "truncate log", "sync log",
                                       "open ",    "sync ",    "write log", "sync log"};
  for (std::uint64_t i = 0; i < kRows; ++i) {
    expected.emplace_back("write log");
    expected.emplace_back("sync log");
  }
  CHECK(watched.trace() == expected);
}

TEST_CASE("a file of a cache and a merged log are synced before they get their names", "[unit]") {
  const ScratchFolder scratch;
  const std::string folder = scratch.path().string();
  const auto cache = MatchCache::open(folder);
  const auto lastCalls = [](const WatchedCalls& watched, std::size_t count) {
    std::vector<std::string> calls;
    for (const std::string& call : watched.trace()) calls.push_back(call.substr(0, call.find(' ')));
    return std::vector<std::string>(calls.end() - static_cast<std::ptrdiff_t>(count), calls.end());
  };
  {
    const WatchedCalls watched(folder);
    REQUIRE(cache->add(matchRow(1)));
    CHECK(lastCalls(watched, 3) == std::vector<std::string>{"write", "sync", "rename"});
  }
  const WatchedCalls watched(folder);
  REQUIRE(writeMatchLog(folder + "/merged", {{matchRow(1).id, matchRow(1)}}));
  CHECK(lastCalls(watched, 5) == std::vector<std::string>{"write", "sync", "rename", "open", "sync"});
}

}  // namespace fulbito::test
