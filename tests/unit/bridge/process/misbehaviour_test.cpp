// Every kind of misbehaviour of a process: the child ends in time, and nothing is left.

#include <chrono>
#include <set>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/support/repetitions.hpp"
#include "tests/unit/bridge/process/children.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

// A deadline as for decisions in a match. Programs that end themselves get more, as bombs need time.
constexpr double kDeadline = 0.1;   // [s]
constexpr double kPatience = 20.0;  // [s]
// Ending kills some dozens of processes at most, on a machine that other tests keep busy.
constexpr double kMostToEnd = 5.0;  // [s]

struct Expected {
  std::string kind;
  std::set<std::string> endings;  ///< allowed endings
  bool ends_itself = true;        ///< otherwise the deadline ends it
};

/// The deadline ends them.
const std::vector<std::string> kEndless = {
    "endless-loop",   "sleep",        "silence",   "ignore-signals", "stop-itself",      "close-input",
    "slow-start",     "garbage",      "half-line", "long-line",      "endless-line",     "stdout-flood",
    "empty-lines",    "stderr-flood", "fork-bomb", "thread-bomb",    "descriptor-flood", "zombies",
    "daemon-and-stay"};

/// They try what the containment denies, and then end well.
const std::vector<std::string> kHarmless = {"exit-zero",          "daemon",        "new-session",
                                            "fork-and-leave",     "signal-others", "trace-others",
                                            "write-outside",      "read-secrets",  "network",
                                            "meddle-with-others", "raise-limits",  "leave-shared-memory",
                                            "gain-rights"};

std::vector<Expected> expectations() {
  const std::set<std::string> no_memory = {"out of memory", "signal 6 (Aborted)", "signal 9 (Killed)",
                                           "exit code 1"};
  std::vector<Expected> expected = {{"segfault", {"signal 11 (Segmentation fault)"}},
                                    {"abort", {"signal 6 (Aborted)"}},
                                    {"illegal-instruction", {"signal 4 (Illegal instruction)"}},
                                    {"divide-by-zero", {"signal 8 (Floating point exception)"}},
                                    {"stack-overflow", {"signal 11 (Segmentation fault)"}},
                                    {"exit-code", {"exit code 7"}},
                                    {"kill-itself", {"signal 9 (Killed)"}},
                                    {"kill-group", {"signal 9 (Killed)"}},
                                    {"kill-all", {"signal 9 (Killed)"}},
                                    {"close-pipes", {"killed"}},
                                    {"close-output", {"killed"}},
                                    {"memory-bomb", no_memory},
                                    {"shared-memory-bomb", no_memory},
                                    {"memory-file-bomb", no_memory},
                                    {"file-bomb", {"signal 25 (File size limit exceeded)"}},
                                    {"many-files", {"exit code 1", "private folder full"}},
                                    {"deep-folders", {"killed", "private folder full"}, false}};
  for (const std::string& kind : kEndless) expected.push_back({kind, {"killed"}, false});
  for (const std::string& kind : kHarmless) expected.push_back({kind, {"exit code 0"}});
  return expected;
}

/// Behaves like a match: listens until the deadline, but not longer than a flood may take.
void listen(Child& child, double seconds) {
  constexpr std::size_t kMost = std::size_t{1} << 22;
  std::string text;
  const auto begin = std::chrono::steady_clock::now();
  while (text.size() < kMost && child.receive(text, seconds) == Child::Received::kBytes) {
    if (std::chrono::steady_clock::now() - begin > std::chrono::duration<double>(seconds)) return;
  }
}

void misbehave(const Expected& expected) {
  const std::string mark = "fulbito-kind-" + std::to_string(::getpid());
  Leftovers leftovers(mark);
  ChildOptions options;
  options.command = {misbehavingTeam(), expected.kind, "--mark", mark};
  options.limits.memory = std::size_t{1} << 27;
  options.limits.processes = 20;
  double seconds = 0.0;
  std::string ending;
  {
    Child child = launched(options);
    leftovers.noteKeepers();
    listen(child, expected.ends_itself ? kPatience : kDeadline);
    const auto begin = std::chrono::steady_clock::now();
    const ChildEnd end = child.end();
    ending = end.reason;
    CHECK_FALSE(end.machine);
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    CHECK(child.takeErrors().size() < 70'000);
  }
  CHECK(expected.endings.count(ending) == 1);
  if (expected.endings.count(ending) == 0) WARN("ended by: " << ending);
  CHECK(seconds < kMostToEnd);
  CHECK(leftovers.found() == "");
}

}  // namespace

TEST_CASE("misbehaving children end in time and leave nothing", "[unit][misbehaviour]") {
  const int count = repetitions();
  REQUIRE(count > 0);
  for (const Expected& expected : expectations()) {
    for (int k = 0; k < count; ++k) {
      INFO(expected.kind << ", repetition " << k);
      misbehave(expected);
    }
  }
}

TEST_CASE("the misbehaving team plays well until its time comes", "[unit]") {
  ChildOptions options;
  options.command = {misbehavingTeam(), "wrong-id", "--at", "2"};
  Child child = launched(options);
  const auto answerTo = [&child](const std::string& line) {
    REQUIRE(child.send(line + "\n"));
    std::string text;
    while (!text.ends_with('\n') && child.receive(text, kPatience) == Child::Received::kBytes) {
    }
    return text;
  };
  CHECK(answerTo(R"({"type":"hello","id":1,"protocol":"fulbito-team/1"})") ==
        R"({"type":"hello","id":1,"protocol":"fulbito-team/1","name":"misbehaving","version":""})"
        "\n");
  CHECK(answerTo(R"({"type":"begin","id":2,"team":"blue"})") == R"({"type":"begin","id":2,"navigators":[]})"
                                                                "\n");
  REQUIRE(child.send("{\"type\":\"ready\",\"now\":{}}\n"));
  CHECK(answerTo(R"({"type":"decide","id":3,"now":{}})") == R"({"type":"decide","id":3,"robots":[]})"
                                                            "\n");
  CHECK(answerTo(R"({"type":"decide","id":4,"now":{}})") == R"({"type":"decide","id":1004,"robots":[]})"
                                                            "\n");
  CHECK(answerTo(R"({"type":"decide","id":5,"now":{}})") == R"({"type":"decide","id":5,"robots":[]})"
                                                            "\n");
}

}  // namespace fulbito
