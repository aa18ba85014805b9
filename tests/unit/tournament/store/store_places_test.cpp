#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <grp.h>
#include <map>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/support/match_rows.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tournament/store/log_reader.hpp"
#include "tournament/store/match_cache.hpp"
#include "tournament/store/match_line.hpp"
#include "tournament/store/match_log.hpp"
#include "tournament/store/merge.hpp"

// Places that cannot be written: full, read-only, forbidden, vanished, replaced by something else. Each case
// runs in a process of its own, with its own limits, user and mounts.
namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kRows = 5;
constexpr std::uint64_t kManyRows = 1000;  // more than the small file system holds

/// "i/o: MESSAGE" and the like; empty without an error.
std::string textOf(const Error& error) {
  constexpr const char* kCodes[] = {"usage", "input", "i/o", "machine", "interrupted"};
  return fmt::format("{}: {}", kCodes[static_cast<std::size_t>(error.code)], error.message);
}

template <typename T>
std::string textOf(const Result<T>& result) {
  return result ? std::string("done") : textOf(result.error());
}

Result<void> addRows(MatchLog& log, std::uint64_t rows, std::uint64_t& kept) {
  for (kept = 0; kept < rows; ++kept) {
    const auto added = log.add(matchRow(kept));
    if (!added) return tl::unexpected<Error>(added.error());
  }
  return {};
}

/// Fills a log as far as it goes.
std::string filled(const std::string& file, std::uint64_t rows = kRows) {
  const auto log = MatchLog::open(file);
  if (!log) return textOf(log.error());
  std::uint64_t kept = 0;
  const auto done = addRows(**log, rows, kept);
  const std::string count = kept == rows ? "all" : kept > 0 ? "some" : "none";
  const auto read = readMatchLog(file);
  return fmt::format("{}, {} kept, {}", textOf(done), count,
                     read && read->size() == kept ? "all there" : "LOST");
}

/// Opens a log, lets it keep some rows, does harm to it, and adds another.
std::string filledAfter(const std::string& file, const std::function<void()>& harm) {
  const auto log = MatchLog::open(file);
  if (!log) return textOf(log.error());
  std::uint64_t kept = 0;
  if (const auto done = addRows(**log, kRows, kept); !done) return textOf(done);
  harm();
  return textOf((*log)->add(matchRow(kRows)));
}

std::string cached(const std::string& folder) {
  const auto cache = MatchCache::open(folder);
  return cache ? textOf(cache->add(matchRow(1))) : textOf(cache.error());
}

/// Writes a merged log over an old one, which must stay if that fails.
std::string merged(const std::string& file) {
  std::map<MatchId, MatchRow> rows;
  for (std::uint64_t i = 0; i < kManyRows; ++i) rows[matchRow(i).id] = matchRow(i);
  const auto size_before = readMatchLog(file, true).map([](const auto& r) { return r.size(); });
  const auto written = writeMatchLog(file, rows);
  const auto size_after = readMatchLog(file, true).map([](const auto& r) { return r.size(); });
  const std::size_t expected = written ? kManyRows : *size_before;
  return textOf(written) + (size_after && *size_after == expected ? "" : ", LOST");
}

std::string readOnly(const std::string& file) { return textOf(readMatchLog(file)); }

void touch(const std::string& file) { std::ofstream(file).flush(); }

/// Takes all room of a file system.
void fillUp(const std::string& file) {
  std::ofstream out(file);
  while (out.put('x').flush()) {
  }
}

void limit(decltype(RLIMIT_FSIZE) resource, rlim_t most) {
  rlimit limits{};
  ::getrlimit(resource, &limits);
  limits.rlim_cur = std::min(most, limits.rlim_max);
  ::setrlimit(resource, &limits);
}

void bindSocket(const std::string& file) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::snprintf(address.sun_path, sizeof address.sun_path, "%s", file.c_str());
  (void)::bind(::socket(AF_UNIX, SOCK_STREAM, 0), reinterpret_cast<const sockaddr*>(&address),
               sizeof address);
}

bool mountMemory(const std::string& folder, const char* options, unsigned long flags = 0) {
  return ::mount("tmpfs", folder.c_str(), "tmpfs", flags, options) == 0;
}

/// Who runs a case.
enum class As : std::uint8_t {
  kUser,    ///< whoever runs the test
  kNobody,  ///< somebody without rights, if the test runs as root
  kMounter  ///< somebody who mounts a file system of 64 KiB at the folder, where nobody else sees it
};

struct Case {
  const char* name;
  std::string expected;  ///< of what `run` tells, with FOLDER for the folder
  std::function<std::string(const std::string& folder)> run;
  As as = As::kUser;
};

bool becomeNobody() {
  constexpr uid_t kNobody = 65534;
  if (::geteuid() != 0) return true;
  return ::setgroups(0, nullptr) == 0 && ::setgid(kNobody) == 0 && ::setuid(kNobody) == 0;
}

/// Makes a user the root of a user namespace of its own, where it may mount.
bool becomeOwnRoot() {
  const std::string user = std::to_string(::geteuid()), group = std::to_string(::getegid());
  if (::unshare(CLONE_NEWUSER) != 0) return false;
  std::ofstream("/proc/self/setgroups") << "deny";
  std::ofstream("/proc/self/gid_map") << "0 " + group + " 1";
  std::ofstream("/proc/self/uid_map") << "0 " + user + " 1";
  return ::geteuid() == 0 && ::getegid() == 0;
}

bool becomeMounter(const std::string& folder) {
  if ((::geteuid() != 0 && !becomeOwnRoot()) || ::unshare(CLONE_NEWNS) != 0) return false;
  return ::mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 && mountMemory(folder, "size=64k");
}

bool become(As as, const std::string& folder) {
  if (as == As::kNobody) return becomeNobody();
  return as == As::kUser || becomeMounter(folder);
}

constexpr const char* kUnavailable = "unavailable";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size()) {
    text.replace(at, what.size(), by);
  }
  return text;
}

std::string toldBy(const Case& c, const std::string& folder) {
  try {
    std::signal(SIGXFSZ, SIG_IGN);  // as the program does
    return become(c.as, folder) ? replaced(c.run(folder), folder, "FOLDER") : kUnavailable;
  } catch (const std::exception& e) {
    return e.what();
  }
}

std::string told(const Case& c) {
  const ScratchFolder scratch(memoryPlace());
  fs::permissions(scratch.path(), fs::perms::all);
  int pipe[2];
  REQUIRE(::pipe(pipe) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string text = toldBy(c, scratch.path().string());
    ::_exit(::write(pipe[1], text.data(), text.size()) == static_cast<ssize_t>(text.size()) ? 0 : 1);
  }
  ::close(pipe[1]);
  std::string text(4096, '\0');
  const ssize_t size = ::read(pipe[0], text.data(), text.size());
  ::close(pipe[0]);
  REQUIRE(::waitpid(child, nullptr, 0) == child);
  std::error_code missing;
  fs::permissions(scratch.path() / "sub", fs::perms::all, missing);  // so that it can be removed
  return text.substr(0, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
}

/// @return cases that could be run
int checkAll(const std::vector<Case>& cases) {
  int run = 0;
  for (const Case& c : cases) {
    INFO(c.name);
    const std::string text = told(c);
    if (text == kUnavailable) {
      WARN("left out, as this system forbids what it needs: " << c.name);
      continue;
    }
    CHECK(text == c.expected);
    ++run;
  }
  return run;
}

std::string cannot(const char* what, const char* reason, const char* file = "FOLDER/log") {
  return fmt::format("i/o: cannot {} '{}': {}", what, file, reason);
}

/// Paths at which no log can be: what they are, made below a folder, and the kernel's word for it.
struct WrongPlace {
  const char* name;
  std::function<std::string(const std::string& folder)> make;
  const char* reason;
};

std::vector<WrongPlace> wrongPlaces() {
  const auto link = [](const std::string& folder, const char* target) {
    fs::create_symlink(target, folder + "/log");
    return folder + "/log";
  };
  return {
      {"missing folder", [](auto& f) { return f + "/none/log"; }, "No such file or directory"},
      {"file for a folder", [](auto& f) { return touch(f + "/file"), f + "/file/log"; }, "Not a directory"},
      {"folder", [](auto& f) { return fs::create_directory(f + "/log"), f + "/log"; }, "Is a directory"},
      {"pipe", [](auto& f) { return ::mkfifo((f + "/log").c_str(), 0600), f + "/log"; },
       "it is not a regular file"},
      {"socket", [](auto& f) { return bindSocket(f + "/log"), f + "/log"; }, "No such device or address"},
      {"full device", [](auto&) { return std::string("/dev/full"); }, "it is not a regular file"},
      {"endless device", [](auto&) { return std::string("/dev/zero"); }, "it is not a regular file"},
      {"loop of links", [&](auto& f) { return link(f, "log"); }, "Too many levels of symbolic links"},
      {"link to nowhere", [&](auto& f) { return link(f, "none/log"); }, "No such file or directory"},
      {"long name", [](auto& f) { return f + "/" + std::string(300, 'x'); }, "File name too long"},
      {"long path", [](auto& f) { return f + replaced(std::string(5000, '/'), "/", "/."); },
       "File name too long"},
      {"empty name", [](auto&) { return std::string(); }, "No such file or directory"}};
}

std::string logIn(const std::string& folder) { return folder + "/log"; }
void freed(const std::string& folder) { mountMemory(folder, "size=8m", MS_REMOUNT); }
void sealed(const std::string& folder) { mountMemory(folder, "size=64k", MS_REMOUNT | MS_RDONLY); }
void only(const std::string& path, int mode) { ::chmod(path.c_str(), static_cast<mode_t>(mode)); }

/// What becomes of a log in whose place `make` puts something else.
template <typename Make>
std::string instead(const std::string& file, const Make& make) {
  return filledAfter(file, [&] {
    fs::remove(file);
    make();
  });
}

}  // namespace

TEST_CASE("a log at an impossible place is an error that names it, for writers and readers", "[unit]") {
  const ScratchFolder scratch(memoryPlace());
  int number = 0;
  for (const WrongPlace& place : wrongPlaces()) {
    INFO(place.name);
    const std::string folder = (scratch.path() / std::to_string(number++)).string();
    fs::create_directory(folder);
    const std::string file = place.make(folder);
    CHECK(textOf(MatchLog::open(file)) == fmt::format("i/o: cannot write '{}': {}", file, place.reason));
    CHECK(readOnly(file) == fmt::format("i/o: cannot read '{}': {}", file, place.reason));
    CHECK(textOf(mergeLogs({file})) == readOnly(file));
  }
  const std::string zero = scratch.path().string() + std::string("/a\0b", 4);
  CHECK(textOf(MatchLog::open(zero)) ==
        fmt::format("i/o: cannot write '{}/a': Invalid argument", scratch.path().string()));
}

TEST_CASE("a full disk keeps what was kept, and freed room lets the work go on", "[unit]") {
  const std::string no_space = cannot("write", "No space left on device");
  const int run = checkAll({
      {"full before", no_space + " done, all kept, all there",
       [&](auto& f) {
         fillUp(f + "/filler");
         const std::string first = filled(logIn(f));
         fs::remove(f + "/filler");
         return first + " " + filled(logIn(f));
       },
       As::kMounter},
      {"full in a line", no_space + ", some kept, all there; done, all kept, all there",
       [&](auto& f) {
         const std::string first = filled(logIn(f), kManyRows);
         freed(f);
         return first + "; " + filled(logIn(f), kManyRows);
       },
       As::kMounter},
      {"no room for names", no_space,
       [&](auto& f) {
         mountMemory(f, "nr_inodes=1", MS_REMOUNT);
         return filled(logIn(f));
       },
       As::kMounter},
      {"cache", "i/o: cannot write into the folder 'FOLDER/cache': no permission or no space; done",
       [&](auto& f) {
         mountMemory(f, "nr_inodes=2", MS_REMOUNT);
         const std::string first = cached(f + "/cache");
         mountMemory(f, "nr_inodes=100", MS_REMOUNT);
         return first + "; " + cached(f + "/cache");
       },
       As::kMounter},
      {"merged log", no_space + "; done",
       [&](auto& f) {
         filled(logIn(f));
         const std::string first = merged(logIn(f));
         freed(f);
         return first + "; " + merged(logIn(f));
       },
       As::kMounter},
  });
  std::printf("%d cases of a full disk\n", run);
}

TEST_CASE("a process at its limits keeps what was kept, and goes on beyond them", "[unit]") {
  const int run = checkAll({
      {"limit in a line",
       cannot("write", "File too large") + ", some kept, all there; done, all kept, all there",
       [&](auto& f) {
         limit(RLIMIT_FSIZE, 1000);
         const std::string first = filled(logIn(f));
         limit(RLIMIT_FSIZE, RLIM_INFINITY);
         return first + "; " + filled(logIn(f));
       }},
      {"limit in the header", cannot("write", "File too large") + "; done, all kept, all there",
       [&](auto& f) {
         limit(RLIMIT_FSIZE, 10);
         const std::string first = filled(logIn(f));
         limit(RLIMIT_FSIZE, RLIM_INFINITY);
         return first + "; " + filled(logIn(f));
       }},
      {"no more open files", "machine: cannot write 'FOLDER/log': Too many open files",
       [&](auto& f) {
         // A sanitizer's first check of a virtual call opens a pipe: the first error comes before the limit.
         static_cast<void>(filled(f + "/none/log"));
         limit(RLIMIT_NOFILE, 0);
         return filled(logIn(f));
       }},
  });
  CHECK(run >= 3);
}

TEST_CASE("a read-only file system is an error, and stays as it is", "[unit]") {
  const int run = checkAll({
      {"read-only file system", cannot("write", "Read-only file system") + " done",
       [&](auto& f) {
         filled(logIn(f));
         sealed(f);
         return filled(logIn(f)) + " " + readOnly(logIn(f));
       },
       As::kMounter},
      {"new log on a read-only file system", cannot("write", "Read-only file system"),
       [&](auto& f) {
         sealed(f);
         return filled(logIn(f));
       },
       As::kMounter},
      {"merged log on a read-only file system", cannot("write", "Read-only file system"),
       [&](auto& f) {
         filled(logIn(f));
         sealed(f);
         return merged(logIn(f));
       },
       As::kMounter},
      {"cache on a read-only file system",
       "i/o: cannot create the folder 'FOLDER/cache': Read-only file system",
       [&](auto& f) {
         sealed(f);
         return cached(f + "/cache");
       },
       As::kMounter},
  });
  std::printf("%d cases of a read-only file system\n", run);
}

TEST_CASE("what is forbidden is an error, and stays as it is", "[unit]") {
  const std::string denied = cannot("write", "Permission denied");
  const int run = checkAll({
      {"read-only file", denied + " done",
       [&](auto& f) {
         filled(logIn(f));
         only(logIn(f), 0444);
         return filled(logIn(f)) + " " + readOnly(logIn(f));
       },
       As::kNobody},
      {"unreadable file", denied + " " + cannot("read", "Permission denied"),
       [&](auto& f) {
         filled(logIn(f));
         only(logIn(f), 0);
         return filled(logIn(f)) + " " + readOnly(logIn(f));
       },
       As::kNobody},
      {"read-only folder", cannot("write", "Permission denied", "FOLDER/sub/log"),
       [&](auto& f) {
         fs::create_directory(f + "/sub");
         only(f + "/sub", 0555);
         return filled(f + "/sub/log");
       },
       As::kNobody},
      {"forbidden folder", cannot("write", "Permission denied", "FOLDER/sub/log"),
       [&](auto& f) {
         fs::create_directory(f + "/sub");
         only(f + "/sub", 0);
         return filled(f + "/sub/log");
       },
       As::kNobody},
  });
  CHECK(run >= 4);
  std::printf("%d cases of what is forbidden\n", run);
}

TEST_CASE("no merged log nor cache gets into a place that is forbidden", "[unit]") {
  const int run = checkAll({
      {"merged log in a read-only folder", cannot("write", "Permission denied", "FOLDER/sub/log"),
       [&](auto& f) {
         fs::create_directory(f + "/sub");
         filled(f + "/sub/log");
         only(f + "/sub", 0555);
         return merged(f + "/sub/log");
       },
       As::kNobody},
      {"merged log for a folder", cannot("write", "it is a folder"),
       [&](auto& f) {
         fs::create_directory(logIn(f));
         return textOf(writeMatchLog(logIn(f), {}));
       }},
      {"cache in a read-only folder", "i/o: cannot write into the folder 'FOLDER': no permission or no space",
       [&](auto& f) {
         fs::create_directory(f + "/sub");
         only(f + "/sub", 0555);
         return replaced(cached(f + "/sub"), f + "/sub", f);
       },
       As::kNobody},
  });
  CHECK(run >= 2);
}

TEST_CASE("a log that vanishes while it is written gets no more matches", "[unit]") {
  const auto in_sub = [](const std::string& folder, const auto& harm) {
    fs::create_directory(folder + "/sub");
    return filledAfter(folder + "/sub/log", harm);
  };
  const std::string missing = cannot("write", "No such file or directory", "FOLDER/sub/log");
  const std::string other = cannot("write", "another program replaced it");
  const int run = checkAll({
      {"folder removed", missing, [&](auto& f) { return in_sub(f, [&] { fs::remove_all(f + "/sub"); }); }},
      {"folder renamed", missing,
       [&](auto& f) { return in_sub(f, [&] { fs::rename(f + "/sub", f + "/old"); }); }},
      {"disk unplugged", cannot("write", "No such file or directory"),
       [&](auto& f) { return filledAfter(logIn(f), [&] { ::umount2(f.c_str(), MNT_DETACH); }); },
       As::kMounter},
      {"folder in its place", other,
       [&](auto& f) { return instead(logIn(f), [&] { fs::create_directory(logIn(f)); }); }},
      {"pipe in its place", other,
       [&](auto& f) { return instead(logIn(f), [&] { ::mkfifo(logIn(f).c_str(), 0600); }); }},
      {"device in its place", other,
       [&](auto& f) { return instead(logIn(f), [&] { fs::create_symlink("/dev/full", logIn(f)); }); }},
      {"loop in its place", cannot("write", "Too many levels of symbolic links"),
       [&](auto& f) { return instead(logIn(f), [&] { fs::create_symlink("log", logIn(f)); }); }},
      {"log in its place", other, [&](auto& f) { return instead(logIn(f), [&] { filled(logIn(f)); }); }},
      {"cut by another", cannot("write", "another program changed it"),
       [&](auto& f) { return filledAfter(logIn(f), [&] { fs::resize_file(logIn(f), 100); }); }},
      {"locked by another process",
       "usage: 'FOLDER/log' is being written by another run; wait for its end, or name another file",
       [&](auto& f) {
         const auto held = MatchLog::open(logIn(f));
         const pid_t child = ::fork();
         if (child == 0) ::_exit(MatchLog::open(logIn(f)) ? 0 : 1);
         int status = 0;
         ::waitpid(child, &status, 0);
         return WEXITSTATUS(status) == 1 ? filled(logIn(f)) : "the lock did not hold";
       }},
      {"cache folder removed", "done",
       [&](auto& f) {
         const auto cache = MatchCache::open(f + "/cache");
         fs::remove_all(f + "/cache");
         return textOf(cache->add(matchRow(1)));
       }},
  });
  CHECK(run >= 10);
  std::printf("%d cases of what vanishes\n", run);
}

}  // namespace fulbito::test
