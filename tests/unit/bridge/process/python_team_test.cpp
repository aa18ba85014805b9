// Mistakes of a Python team with the SDK, as its child process shows them.

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <unistd.h>

#include "tests/support/catch.hpp"
#include "tests/unit/bridge/process/children.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

namespace fs = std::filesystem;

constexpr double kPatience = 30.0;  // [s] an interpreter on a busy machine
constexpr double kDeadline = 0.3;   // [s]

/// The lines of the simulator in the recorded sample session.
std::vector<std::string> sampleLines() {
  std::ifstream file(fs::path(FULBITO_SOURCE_DIR) / "docs/team-protocol-session.txt");
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("> ")) lines.push_back(line.substr(2) + "\n");
  }
  REQUIRE(lines.size() > 3);
  return lines;
}

std::string answerTo(Child& child, const std::string& request, double seconds) {
  std::string text;
  if (!child.send(request)) return text;
  while (!text.ends_with('\n') && child.receive(text, seconds) == Child::Received::kBytes) {
  }
  return text;
}

struct Outcome {
  std::string answer;  ///< to the first decision
  std::string errors;
  std::string ending;
};

Outcome outcomeOf(const std::string& kind, const std::string& mark) {
  const fs::path folder = FULBITO_SOURCE_DIR;
  ChildOptions options;
  options.command = {"python3", (folder / "tests/misbehaviour/misbehaving_team.py").string(), kind, "1",
                     mark};
  options.own_folder = (folder / "tests/misbehaviour").string();
  options.readable = {(folder / "sdk/python").string()};
  options.limits.memory = std::size_t{1} << 28;
  Child child = launched(options);
  Outcome outcome;
  for (const std::string& line : sampleLines()) {
    const bool decides = line.find("\"type\":\"decide\"") != std::string::npos;
    if (line.find("\"id\":") == std::string::npos) {
      REQUIRE(child.send(line));
      continue;
    }
    outcome.answer = answerTo(child, line, decides && kind == "sleep" ? kDeadline : kPatience);
    if (decides) break;
  }
  // A program without an answer has ended, or never answers. An interpreter takes a moment to end.
  if (outcome.answer.empty() && kind != "sleep") {
    allOutput(child, kPatience);
    ::usleep(500'000);
  }
  outcome.ending = child.end().reason;
  outcome.errors = child.takeErrors();
  return outcome;
}

}  // namespace

TEST_CASE("a Python team that misbehaves says why and leaves nothing", "[unit][python]") {
  struct Expected {
    std::string kind, answer, errors, ending;
  };
  for (const Expected& expected : std::vector<Expected>{
           {"exception", "", "RuntimeError: this team has a fault", "exit code 1"},
           {"exit", "", "", "exit code 5"},
           {"no-answer", "", "AttributeError", "exit code 1"},
           {"recursion", "", "RecursionError", "exit code 1"},
           {"nan", "\"left\":null,\"right\":null", "", "killed"},
           {"words", "", "ValueError", "exit code 1"},
           {"unknown-robot", "", "robot 99", "exit code 1"},
           {"prints", "\"robots\"", "a line for standard output\nbytes for standard output", "killed"},
           {"interrupt", "", "", "exit code 0"},
           {"sleep", "", "", "killed"},
           {"busy-threads", "\"robots\"", "", "killed"},
           {"leaves-child", "\"robots\"", "", "killed"},
           {"memory", "", "MemoryError", "exit code 1"}}) {
    INFO(expected.kind);
    const std::string mark = "fulbito-python-" + std::to_string(::getpid());
    Leftovers leftovers(mark);
    const Outcome outcome = outcomeOf(expected.kind, mark);
    CHECK(outcome.answer.empty() == expected.answer.empty());
    CHECK_THAT(outcome.answer, Catch::Contains(expected.answer));
    CHECK_THAT(outcome.errors, Catch::Contains(expected.errors));
    CHECK(outcome.ending == expected.ending);
    CHECK(leftovers.found() == "");
  }
}

}  // namespace fulbito
