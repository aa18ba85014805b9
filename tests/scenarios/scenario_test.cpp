#include "tests/scenarios/scenario.hpp"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>

#include "referee/rules/clauses.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::test {
namespace {

std::vector<std::string> scenarioNames() {
  const std::filesystem::path root = FULBITO_SCENARIOS;
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
    if (entry.path().filename() != "scenario.toml") continue;
    names.push_back(std::filesystem::relative(entry.path().parent_path(), root).generic_string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace

TEST_CASE("every scenario is judged as its file says, in four variants", "[scenarios]") {
  const std::vector<std::string> names = scenarioNames();
  CHECK(names.size() >= 60);
  for (const std::string& name : names) {
    const auto scenario = loadScenario(std::string(FULBITO_SCENARIOS) + "/" + name, name);
    INFO(name);
    if (!scenario) FAIL_CHECK(scenario.error().message);
    if (!scenario) continue;
    for (const bool sides : {false, true}) {
      for (const bool colours : {false, true}) {
        INFO((sides ? "sides exchanged" : "sides as given"));
        INFO((colours ? "colours swapped" : "colours as given"));
        CHECK(playScenario(*scenario, {sides, colours}) == "");
      }
    }
  }
}

TEST_CASE("whatever stops play is called in a scenario, and has words", "[scenarios]") {
  std::set<std::string, std::less<>> called;
  for (const std::string& name : scenarioNames()) {
    const auto scenario = loadScenario(std::string(FULBITO_SCENARIOS) + "/" + name, name);
    if (!scenario) continue;
    for (const ExpectedEvent& event : scenario->expected) called.insert(event.clause);
  }
  for (const clause::Clause& call : clause::kClauses) {
    if (call.name == "match.abandoned" || call.name == "team.failed") continue;  // no rules
    INFO(call.name);
    CHECK(called.contains(call.name));
    if (clause::isFoul(call.name)) CHECK_FALSE(call.title.empty());
  }
  for (const std::string& name : called) {
    INFO(name);
    CHECK(clause::find(name) != nullptr);
  }
}

}  // namespace fulbito::test
