#include "bridge/process/child.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/bridge/process/children.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

double secondsSince(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

ChildOptions cat() {
  ChildOptions options;
  options.command = {"cat"};
  return options;
}

/// Sends and receives until `bytes` have come back.
std::string returned(Child& child, std::size_t bytes) {
  std::string text;
  while (text.size() < bytes && child.receive(text, 20.0) == Child::Received::kBytes) {
  }
  return text;
}

Error launchError(const ChildOptions& options) {
  Result<Child> child = Child::launch(options);
  REQUIRE_FALSE(child);
  return child.error();
}

Error launchError(const std::string& program) {
  ChildOptions options;
  options.command = {program};
  return launchError(options);
}

}  // namespace

TEST_CASE("a child hears and answers", "[unit]") {
  Leftovers leftovers("fulbito-no-such-mark");
  {
    Child child = launched(cat());
    for (const std::string line : {"one\n", "two\n", "three\n"}) {
      REQUIRE(child.send(line));
      CHECK(returned(child, line.size()) == line);
    }
    CHECK(child.end().reason == "killed");
    CHECK(child.end().reason == "killed");
    CHECK_FALSE(child.send("more"));
    std::string text;
    CHECK(child.receive(text, 1.0) == Child::Received::kClosed);
  }
  CHECK(leftovers.found() == "");
}

TEST_CASE("a child's output comes in pieces, and what a pipe does not take waits", "[unit]") {
  Child child = launched(cat());
  std::string sent;
  while (sent.size() < 8'000'000) sent += std::to_string(sent.size()) + " ";
  REQUIRE(child.send(sent));
  const std::string text = returned(child, sent.size());
  CHECK((text == sent));
}

TEST_CASE("at most 16 MiB wait for a child that does not read", "[unit]") {
  Child child = launched(shell("sleep 60"));
  const std::string mebibyte(std::size_t{1} << 20, 'x');
  int accepted = 0;
  while (accepted < 100 && child.send(mebibyte)) ++accepted;
  CHECK(accepted == 16);
  std::string text;
  CHECK(child.receive(text, 0.0) == Child::Received::kNothing);
}

TEST_CASE("a closed pipe is told, and raises no signal", "[unit]") {
  struct sigaction before{};
  ::sigaction(SIGPIPE, nullptr, &before);
  REQUIRE(before.sa_handler == SIG_DFL);
  Child child = launched(shell("exec 0<&-; echo closed; sleep 60"));
  CHECK(returned(child, 7) == "closed\n");
  CHECK_FALSE(child.send("x"));
  CHECK_FALSE(child.send("y"));
  struct sigaction after{};
  ::sigaction(SIGPIPE, nullptr, &after);
  CHECK(after.sa_handler == SIG_DFL);
  sigset_t pending;
  ::sigpending(&pending);
  CHECK(sigismember(&pending, SIGPIPE) == 0);
}

TEST_CASE("a wait for output ends in time", "[unit]") {
  Child child = launched(shell("while :; do echo complaint >&2; done"));
  std::string text;
  const auto begin = std::chrono::steady_clock::now();
  CHECK(child.receive(text, 0.2) == Child::Received::kNothing);
  // Lines on standard error interrupt the wait, but do not lengthen it.
  CHECK(secondsSince(begin) >= 0.19);
  CHECK(secondsSince(begin) < 5.0);
  for (const double nothing : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    CHECK(child.receive(text, nothing) == Child::Received::kNothing);
  }
}

TEST_CASE("a flood of errors does not lengthen a wait for output", "[unit]") {
  Child child = launched(shell("cat /dev/zero >&2; echo ended"));
  std::string text;
  CHECK(child.receive(text, 1.0) == Child::Received::kNothing);
  // The wait counts only time asleep, not time to read. So it reads a bounded part, and the rest waits.
  const std::string errors = child.takeErrors();
  const std::size_t note = errors.find("\n[");
  REQUIRE(note != std::string::npos);
  CHECK(std::stoull(errors.substr(note + 2)) < 6 * 1024 * 1024);
}

TEST_CASE("standard error is kept up to a bound", "[unit]") {
  Child little = launched(shell("echo first >&2; echo second >&2"));
  CHECK(allOutput(little) == "");
  CHECK(little.takeErrors() == "first\nsecond\n");
  CHECK(little.takeErrors() == "");

  Child much = launched(shell("head -c 1000000 /dev/zero | tr '\\0' x >&2; echo done"));
  CHECK(allOutput(much) == "done\n");
  const std::string errors = much.takeErrors();
  CHECK(errors.size() < 65536 + 100);
  CHECK(errors.find("\n[934464 more bytes of standard error]\n") == 65536);
}

TEST_CASE("how a child ended is told", "[unit]") {
  const auto ending = [](const std::string& line) {
    Child child = launched(shell(line));
    allOutput(child);
    const ChildEnd end = child.end();
    CHECK_FALSE(end.machine);  // whatever it does to itself
    return end.reason;
  };
  CHECK(ending("exit 0") == "exit code 0");
  CHECK(ending("exit 3") == "exit code 3");
  CHECK(ending("kill -SEGV $$") == "signal 11 (Segmentation fault)");
  CHECK(ending("kill -KILL $$") == "signal 9 (Killed)");
  CHECK(ending("exec 1>&-; sleep 0.3; exit 4") == "exit code 4");  // like an interpreter that ends slowly
  CHECK(ending("exec 1>&-; sleep 60") == "killed");
}

TEST_CASE("a child that no longer reads may still end by itself", "[unit]") {
  Child child = launched(shell("exec 0<&-; echo closed; sleep 0.3; exit 5"));
  CHECK(returned(child, 7) == "closed\n");
  CHECK_FALSE(child.send("x"));
  CHECK(child.end().reason == "exit code 5");
}

TEST_CASE("what cannot be run is refused with the reason", "[unit]") {
  const ScratchFolder folder;
  ::chmod(folder.path().c_str(), 0755);
  const std::string no_bit = folder.write("no-bit", "#!/bin/sh\n");
  const std::string no_program = folder.write("no-program", "hello\n");
  const std::string broken = folder.write("broken", "\177ELF and no more");
  const std::string lost = folder.write("lost", "#!/no/such/interpreter\n");
  for (const std::string& file : {no_program, broken, lost}) ::chmod(file.c_str(), 0755);
  for (const auto& [program, why] : std::vector<std::pair<std::string, std::string>>{
           {"", "empty"},
           {"no-such-program-anywhere", "no such program in PATH"},
           {(folder.path() / "absent").string(), "no such file"},
           {folder.path().string(), "not a file"},
           {no_bit, "not executable (chmod +x)"},
           {no_program, "neither a program nor a script"},
           {broken, "neither a program nor a script"},
           {lost, "interpreter that does not exist"}}) {
    const Error error = launchError(program);
    CHECK(error.code == ErrorCode::kUsage);
    CHECK_THAT(error.message, Catch::Contains(why));
    CHECK_THAT(error.message, Catch::Contains("'" + program + "'"));
  }
  ChildOptions options = cat();
  options.own_folder = (folder.path() / "absent").string();
  CHECK_THAT(launchError(options).message, Catch::Contains("is not a folder"));
  options = cat();
  options.limits.processes = 0;
  CHECK_THAT(launchError(options).message, Catch::Contains("at least"));
}

TEST_CASE("a child's surroundings are its own", "[unit][sandbox]") {
  const ScratchFolder folder;
  ::chmod(folder.path().c_str(), 0755);
  const std::string program = folder.write("team.sh",
                                           "#!/bin/sh\nenv -u PWD -u OLDPWD -u SHLVL -u _ | sort; pwd\n"
                                           "echo kept > $HOME/file && cat $HOME/file\n");
  ::chmod(program.c_str(), 0755);
  ::setenv("FULBITO_SECRET", "secret", 1);
  ChildOptions options;
  options.command = {program};
  Child at_home = launched(options);
  const std::string text = allOutput(at_home);
  CHECK_THAT(text, Catch::StartsWith("HOME=/"));
  CHECK_THAT(text,
             Catch::Contains("\nTMPDIR=/") && Catch::Contains("\nPATH=/") && Catch::Contains("\nLANG="));
  CHECK(text.find("SECRET") == std::string::npos);
  CHECK_THAT(text, Catch::EndsWith("\nkept\n"));
  CHECK(std::count(text.begin(), text.end(), '\n') == 6);

  options.own_folder = folder.path().string();
  Child in_folder = launched(options);
  CHECK_THAT(allOutput(in_folder), Catch::Contains("\n" + folder.path().string() + "\n"));
  ::unsetenv("FULBITO_SECRET");
}

TEST_CASE("descriptors of the launching program stay closed in a child", "[unit]") {
  const int open = ::dup2(STDERR_FILENO, 77);
  Child child = launched(shell("ls -l /proc/self/fd; true"));
  const std::string text = allOutput(child);
  ::close(open);
  CHECK_THAT(text, Catch::Contains(" 0 -> "));
  CHECK(text.find(" 77 -> ") == std::string::npos);
  // Three descriptors, and the folder that ls reads.
  CHECK(std::count(text.begin(), text.end(), '>') == 4);
}

TEST_CASE("a child outlives the thread that launched it", "[unit]") {
  std::optional<Child> child;
  std::thread([&child] { child.emplace(launched(cat())); }).join();
  std::this_thread::sleep_for(std::chrono::milliseconds(50));
  REQUIRE(child->send("still here\n"));
  CHECK(returned(*child, 11) == "still here\n");
}

TEST_CASE("a child can be stopped first and waited for later", "[unit]") {
  Child child = launched(cat());
  child.stop();
  std::string text;
  CHECK(child.receive(text, 20.0) == Child::Received::kClosed);
  CHECK(child.end().reason == "killed");
  child.stop();
}

TEST_CASE("a child ends with its keeper", "[unit][sandbox]") {
  const std::string mark = "fulbito-keeperless-" + std::to_string(::getpid());
  Leftovers leftovers(mark);
  {
    ChildOptions options;
    options.command = {misbehavingTeam(), "ignore-signals", "--mark", mark};
    Child child = launched(options);
    leftovers.noteKeepers();
    leftovers.killKeepers();
    std::string text;
    CHECK(child.receive(text, 20.0) == Child::Received::kClosed);
    const ChildEnd end = child.end();
    CHECK(end.reason == "its keeper ended: signal 9 (Killed)");
    CHECK(end.machine);
  }
  CHECK(leftovers.found() == "");
}

TEST_CASE("a child is not started where the machine leaves less than it may have", "[unit]") {
  struct Lack {
    int resource;
    rlim_t left;
    const char* flag;
  };
  for (const Lack& lack :
       {Lack{RLIMIT_NOFILE, 31, "ulimit -n"},
#ifndef FULBITO_SANITIZED  // which end a program without much memory
        Lack{RLIMIT_AS, rlim_t{900} << 20, "ulimit -v"}, Lack{RLIMIT_DATA, rlim_t{900} << 20, "ulimit -d"},
#endif
        Lack{RLIMIT_STACK, rlim_t{1} << 20, "ulimit -s"}, Lack{RLIMIT_FSIZE, rlim_t{8} << 20, "ulimit -f"},
        Lack{RLIMIT_NPROC, 30, "ulimit -u"}}) {
    INFO(lack.flag);
    const pid_t limited = ::fork();
    if (limited == 0) {
      const rlimit limit{lack.left, lack.left};
      ::setrlimit(static_cast<__rlimit_resource>(lack.resource), &limit);
      const Result<Child> child = Child::launch(cat());
      const bool named = !child && child.error().code == ErrorCode::kMachine &&
                         child.error().message.find(lack.flag) != std::string::npos;
      ::_exit(named ? 0 : 1);
    }
    int status = 0;
    ::waitpid(limited, &status, 0);
    CHECK(status == 0);
  }
}

TEST_CASE("memory that runs out around a child is not its fault", "[unit][sandbox]") {
  namespace fs = std::filesystem;
  // In version 1, since a group of version 2 that has processes can have no groups below it.
  const fs::path group = "/sys/fs/cgroup/memory/fulbito-test-" + std::to_string(::getpid());
  std::error_code refused;
  if (!fs::exists("/sys/fs/cgroup/memory/memory.limit_in_bytes") || !fs::create_directory(group, refused))
    return;
  std::ofstream(group / "memory.limit_in_bytes") << (rlim_t{96} << 20);
  const pid_t small = ::fork();
  if (small == 0) {
    std::ofstream(group / "cgroup.procs") << ::getpid();
    ChildOptions options;
    options.command = {misbehavingTeam(), "shared-memory-bomb"};
    auto child = Child::launch(options);
    if (!child) ::_exit(2);
    allOutput(*child);
    const ChildEnd end = child->end();
    ::_exit(end.machine && end.reason == "the machine is out of memory" ? 0 : 1);
  }
  int status = 0;
  ::waitpid(small, &status, 0);
  CHECK(status == 0);
  fs::remove(group, refused);
}

TEST_CASE("children end with the program that launched them, however it ends", "[unit][sandbox]") {
  const std::string mark = "fulbito-orphan-" + std::to_string(::getpid());
  Leftovers leftovers(mark);
  const pid_t launcher = ::fork();
  if (launcher == 0) {
    ChildOptions options;
    options.command = {misbehavingTeam(), "daemon-and-stay", "--mark", mark};
    Result<Child> first = Child::launch(options);
    options.command[1] = "ignore-signals";
    Result<Child> second = Child::launch(options);
    while (processesWith(mark) < 3) ::usleep(1000);
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(launcher, &status, 0);
  REQUIRE(WIFSIGNALED(status));
  for (int round = 0; round < 1000 && !leftovers.found().empty(); ++round) ::usleep(10'000);
  CHECK(leftovers.found() == "");
}

TEST_CASE("250 children at once, from several threads, with 1024 descriptors", "[unit]") {
  rlimit before{};
  ::getrlimit(RLIMIT_NOFILE, &before);
  const rlimit usual{std::min<rlim_t>(1024, before.rlim_max), before.rlim_max};
  ::setrlimit(RLIMIT_NOFILE, &usual);
  Leftovers leftovers("fulbito-no-such-mark");
  {
    constexpr int kThreads = 5, kEach = 50;
    std::vector<std::vector<Child>> children(kThreads);
    std::vector<std::thread> threads;
    std::vector<std::string> errors(kThreads);
    for (int k = 0; k < kThreads; ++k) {
      threads.emplace_back([&own = children[k], &error = errors[k]] {
        for (int number = 0; number < kEach; ++number) {
          Result<Child> child = Child::launch(cat());
          if (child) own.push_back(std::move(*child));
          if (!child) error += child.error().message + "\n";
        }
      });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::string& error : errors) CHECK(error == "");
    for (auto& own : children) {
      REQUIRE(own.size() == kEach);
      for (Child& child : own) CHECK(child.send("hello\n"));
    }
    for (auto& own : children) {
      for (Child& child : own) CHECK(returned(child, 6) == "hello\n");
    }
  }
  CHECK(leftovers.found() == "");
  ::setrlimit(RLIMIT_NOFILE, &before);
}

}  // namespace fulbito
