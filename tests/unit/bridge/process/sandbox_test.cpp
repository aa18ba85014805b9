#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <netinet/in.h>
#include <sched.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/bridge/process/children.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// Whether this system lets this user have PID and mount namespaces. Many containers do not; refusing.cpp
/// imitates one.
bool hasNamespaces() {
  unsigned long flags = CLONE_NEWPID | CLONE_NEWNS | SIGCHLD;
  if (::geteuid() != 0) flags |= CLONE_NEWUSER;
  const auto process = static_cast<pid_t>(::syscall(SYS_clone, flags, nullptr, nullptr, nullptr, nullptr));
  if (process == 0) ::_exit(0);
  return process > 0 && ::waitpid(process, nullptr, 0) == process;
}

/// Version of the kernel's Landlock; below 1: none.
long landlockVersion() { return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, 1U); }

int processesOfThisUser() {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    struct stat status{};
    if (::stat(entry.path().c_str(), &status) == 0 && status.st_uid == ::geteuid()) ++count;
  }
  return count;
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += word + "\n";
  return text;
}

std::string errorsOf(const std::vector<std::string>& command) {
  ChildOptions options;
  options.command = command;
  Child child = launched(options);
  allOutput(child);
  return child.takeErrors();
}

bool runs(const std::string& line) { return std::system((line + " >/dev/null 2>&1").c_str()) == 0; }

std::string outputOf(const std::vector<std::string>& command) {
  ChildOptions options;
  options.command = command;
  Child child = launched(options);
  const std::string text = allOutput(child);
  INFO(child.takeErrors());
  CHECK(child.end().reason == "exit code 0");
  return text;
}

}  // namespace

TEST_CASE("the layers that a child reached are told", "[unit][sandbox]") {
  Child child = launched(shell("true"));
  const Containment& reached = child.containment();
  INFO("layers:\n" << joined(reached.layers) << "missing:\n" << joined(reached.missing));
  for (const char* layer : {"process-group", "parent-death", "no-new-privs", "rlimits", "seccomp"}) {
    CHECK(has(reached.layers, layer));
  }
  CHECK(has(reached.layers, "cgroup") != has(reached.layers, "memory-watch"));
  CHECK(has(reached.layers, "own-user") == (::geteuid() == 0));
  CHECK(has(reached.layers, "pid-namespace") == hasNamespaces());
  CHECK(has(reached.layers, "mount-namespace") == hasNamespaces());
  CHECK(has(reached.layers, "landlock") == (landlockVersion() >= 1));
  CHECK(reached.missing.empty() == (hasNamespaces() && landlockVersion() >= 1));
  if (!hasNamespaces())
    CHECK(reached.missing[0] == "pid-namespace: not allowed here: Operation not permitted");
}

TEST_CASE("a required layer that is missing is an error", "[unit][sandbox]") {
  ChildOptions options = shell("true");
  options.sandbox_required = true;
  const Result<Child> child = Child::launch(options);
  CHECK(child.has_value() == (hasNamespaces() && landlockVersion() >= 1));
  if (child) return;
  CHECK(child.error().code == ErrorCode::kUsage);
  CHECK_THAT(child.error().message, Catch::StartsWith("the sandbox lacks what is required: "));
}

TEST_CASE("limits of processes bind root as well", "[unit][sandbox]") {
  for (const std::string kind : {"fork-bomb", "thread-bomb"}) {
    const std::string mark = "fulbito-bomb-" + std::to_string(::getpid());
    ChildOptions options;
    options.command = {misbehavingTeam(), kind, "--mark", mark};
    options.limits.processes = 10;
    const int others = processesOfThisUser();
    Child child = launched(options);
    const bool alone = has(child.containment().layers, "pid-namespace");
    if (kind == "fork-bomb") {
      for (int round = 0; alone && round < 1000 && processesWith(mark) < 10; ++round) ::usleep(10'000);
      ::usleep(200'000);
      // If the user's other processes count as well, one that starts takes a place and one that ends leaves
      // it.
      CHECK(processesWith(mark) <= 10 + (alone ? 0 : others));
      if (alone) CHECK(processesWith(mark) == 10);
    } else {
      ::usleep(500'000);
    }
    CHECK(child.takeErrors() == "");
    child.end();
    CHECK(processesWith(mark) == 0);
  }
}

TEST_CASE("processor time is limited", "[unit][sandbox]") {
  ChildOptions options;
  options.command = {misbehavingTeam(), "endless-loop"};
  options.limits.cpu_seconds = 1;
  Child child = launched(options);
  allOutput(child, 60.0);
  CHECK(child.end().reason == "signal 24 (CPU time limit exceeded)");
}

TEST_CASE("a team reads its own files and no others", "[unit][sandbox]") {
  const ScratchFolder own, further, secret;
  for (const ScratchFolder* folder : {&own, &further, &secret}) {
    ::chmod(folder->path().c_str(), 0777);
    ::chmod(folder->write("file", "content\n").c_str(), 0666);
  }
  ChildOptions options = shell(
      "for folder in " + own.path().string() + " " + further.path().string() + " " + secret.path().string() +
      "; do cat $folder/file; touch $folder/new && echo WROTE; rm -f $folder/file; done");
  options.own_folder = own.path().string();
  options.readable = {further.path().string()};
  Child child = launched(options);
  const std::string everything = "content\nWROTE\ncontent\nWROTE\ncontent\nWROTE\n";
  CHECK(allOutput(child) == (landlockVersion() < 1 ? everything : "content\ncontent\n"));
}

TEST_CASE("of a program in the user's own bin a team reads the installation, not the home",
          "[unit][sandbox]") {
  if (landlockVersion() < 1) return;
  const ScratchFolder scratch;
  const std::filesystem::path home = scratch.path();
  for (const char* folder : {"bin", "lib", "mail"}) std::filesystem::create_directories(home / folder);
  for (const char* file : {"lib/module", "mail/letter", "key"}) scratch.write(file, std::string(file) + "\n");
  const std::string program =
      scratch.write("bin/run", "#!/bin/sh\ncd \"$1\" && cat lib/module mail/letter key\n");
  std::filesystem::permissions(home / "bin" / "run", std::filesystem::perms(0755));
  const auto seen = [&](const char* as_home) {
    const std::string before = std::getenv("HOME") != nullptr ? std::getenv("HOME") : "";
    ::setenv("HOME", as_home, 1);
    ChildOptions options;
    options.command = {program, home.string()};
    Child child = launched(options);
    const std::string text = allOutput(child);
    ::setenv("HOME", before.c_str(), 1);
    return text;
  };
  CHECK(seen(home.c_str()) == "lib/module\n");
  CHECK(seen("/nowhere") == "lib/module\nmail/letter\nkey\n");
}

TEST_CASE("folders that are nested too deep for a path are removed", "[unit][sandbox]") {
  Leftovers leftovers("fulbito-no-such-mark");
  {
    ChildOptions options;
    options.command = {misbehavingTeam(), "deep-folders"};
    Child child = launched(options);
    std::string text;
    child.receive(text, 1.0);
    const auto begin = std::chrono::steady_clock::now();
    child.end();
    // Otherwise the folder is on a disk, which removes files in its own time.
    if (has(child.containment().layers, "mount-namespace")) {
      CHECK(std::chrono::steady_clock::now() - begin < std::chrono::seconds(2));
    }
  }
  CHECK(leftovers.found() == "");
}

TEST_CASE("attacks are refused", "[unit][sandbox]") {
  // Before version 6, only a PID namespace protects a user's other processes.
  if (landlockVersion() < (hasNamespaces() ? 1 : 6)) return;
  const ScratchFolder folder;
  ::chmod(folder.path().c_str(), 0777);
  const std::string victim = folder.write("recording", "content");
  ::chmod(victim.c_str(), 0666);
  for (const std::string kind :
       {"signal-others", "trace-others", "write-outside", "read-secrets", "network", "meddle-with-others",
        "raise-limits", "leave-shared-memory", "gain-rights"}) {
    const std::string errors = errorsOf({misbehavingTeam(), kind, "--victim-in", folder.path().string()});
    CHECK(errors.find("GOT THROUGH") == std::string::npos);
    // A PID namespace has no other processes to signal.
    if (kind.find("others") == std::string::npos) CHECK_THAT(errors, Catch::Contains("refused"));
    std::string content;
    std::ifstream(victim) >> content;
    CHECK(content == "content");
  }
}

TEST_CASE("the network is for teams that are allowed it", "[unit][sandbox]") {
  ChildOptions options;
  options.command = {misbehavingTeam(), "network"};
  options.limits.network = true;
  Child child = launched(options);
  allOutput(child);
  const std::string errors = child.takeErrors();
  CHECK_THAT(errors, Catch::Contains("a connection: GOT THROUGH"));
  CHECK_THAT(errors, Catch::Contains("a datagram: GOT THROUGH"));
  CHECK_THAT(errors, Catch::Contains("a socket of a service: refused: Permission denied"));
}

TEST_CASE("interpreters and runtimes work inside", "[unit][sandbox]") {
  CHECK(outputOf({"sh", "-c", "echo one | cat; ls / >/dev/null 2>&1; sleep 0.01"}) == "one\n");
  if (runs("python3 -V")) {
    CHECK(
        outputOf({"python3", "-c",
                  "import json, random, subprocess, tempfile, threading\n"
                  "t = threading.Thread(target=print, args=('thread',)); t.start(); t.join()\n"
                  "print(subprocess.run(['echo', 'process'], capture_output=True).stdout.decode().strip())\n"
                  "with tempfile.TemporaryFile() as file: print('file', flush=True)\n"}) ==
        "thread\nprocess\nfile\n");
  }
  if (runs("node --version"))
    CHECK(outputOf({"node", "-e", "setTimeout(() => console.log('later'), 1)"}) == "later\n");
  if (runs("java -version")) CHECK_THAT(outputOf({"java", "--version"}), Catch::Contains("Runtime"));
}

TEST_CASE("a child can have a network of its own, whose sockets its launcher gets", "[unit][sandbox]") {
  ChildOptions options = shell("sleep 60");
  options.limits.network = true;
  options.sockets = 2;
  if (!hasNamespaces()) {
    const auto refused = Child::launch(options);
    REQUIRE_FALSE(refused);
    CHECK(refused.error().code == ErrorCode::kUsage);
    CHECK(refused.error().message.find("network-namespace") != std::string::npos);
    return;
  }
  Child here = launched(options), there = launched(options);
  CHECK(has(here.containment().layers, "network-namespace"));
  const auto own = here.takeSockets(), others = there.takeSockets();
  REQUIRE(own.size() == 2);
  REQUIRE(others.size() == 2);
  CHECK(here.takeSockets().empty());
  // Both networks have all ports, and a route for multicast at the loopback.
  const sockaddr_in group{AF_INET, htons(10002), {htonl(0xe0000001)}, {}};
  const auto* address = reinterpret_cast<const sockaddr*>(&group);
  const ip_mreq membership{group.sin_addr, {}};
  for (const auto* sockets : {&own, &others}) {
    REQUIRE(::bind((*sockets)[0].number(), address, sizeof group) == 0);
    REQUIRE(::setsockopt((*sockets)[0].number(), IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership,
                         sizeof membership) == 0);
  }
  REQUIRE(::sendto(own[1].number(), "x", 1, 0, address, sizeof group) == 1);
  char byte = 0;
  CHECK(::recv(own[0].number(), &byte, 1, 0) == 1);
  CHECK(::recv(others[0].number(), &byte, 1, 0) == -1);
}

}  // namespace fulbito
