#include <cctype>
#include <set>
#include <sstream>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/json_lines.hpp"

using namespace fulbito::test;

namespace {

/// Words in the code spans of a page: what stands between backticks, outside of blocks.
std::set<std::string> codeWords(const std::string& page) {
  std::set<std::string> words;
  std::istringstream lines(page);
  bool block = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) block = !block;
    if (block) continue;
    bool code = false;
    std::string word;
    for (const char c : line + "`") {
      const bool part = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-';
      if (code && part) {
        word += c;
      } else if (!word.empty()) {
        words.insert(std::exchange(word, ""));
      }
      if (c == '`') code = !code;
    }
  }
  return words;
}

/// Objects whose keys are data: clauses, kinds of restarts, bodies, figures of a check, facts of a team.
bool holdsData(const std::string& key, const Json& value) {
  return value.is_object() && (key == "calls" || key == "restarts" || key == "events" || key == "bodies" ||
                               key == "figures" || key == "origin");
}

void collect(const Json& json, std::set<std::string>& keys) {
  for (const auto& [key, value] : json.items()) {
    if (json.is_object()) keys.insert(key);
    if (!json.is_object() || !holdsData(key, value)) {
      if (value.is_structured()) collect(value, keys);
      continue;
    }
    for (const Json& count : value) {
      if (count.is_structured()) collect(count, keys);
    }
  }
}

/// The keys of what a command prints: one object, or one per line.
std::set<std::string> keysOf(const Output& output) {
  std::set<std::string> keys;
  const Json whole = Json::parse(output.out, nullptr, false);
  if (!whole.is_discarded()) {
    collect(whole, keys);
  } else {
    for (const Json& line : jsonLines(output.out)) collect(line, keys);
  }
  return keys;
}

}  // namespace

TEST_CASE("docs/results-format.md names every key that is printed as JSON", "[cli]") {
  const std::set<std::string> known = codeWords(contentOf(FULBITO_RESULTS_PAGE));
  REQUIRE(known.count("schema_version") == 1);
  const Sandbox box;
  box.works("match libero classic --half-seconds 10 --record a.fbr");
  box.works("match libero chaser --half-seconds 10 --seed 2 --record b.fbr --drawings");
  const std::string bytes = contentOf(box.path / "a.fbr");
  box.write("cut.fbr", bytes.substr(0, bytes.size() / 2));
  const auto expect = [&](const std::string& arguments, std::size_t least = 4) {
    const Output output = box.run(arguments);
    INFO(arguments << output.err);
    const std::set<std::string> keys = keysOf(output);
    REQUIRE(keys.size() >= least);
    for (const std::string& key : keys) {
      INFO(key);
      CHECK(known.count(key) == 1);
    }
  };
  expect("match libero classic --half-seconds 5 --json --profile");
  expect("match chaser chaser --half-seconds 1 -n 2 --json");
  expect("match libero classic --half-seconds 5 --events -");
  expect("run --layout corner:0 --json --record t.fbr");
  expect("compare --trials 1 --json --pictures 0");
  expect("compare --suite short --only 3 --navigators bezier --json --pictures 0");
  for (const char* kind :
       {"teams", "navigators", "suites", "cases", "robots", "physics", "fields", "rules"}) {
    expect(std::string("list ") + kind + " --json", 3);
  }
  expect("tune random --half-seconds 2 --iterations 1 --pairs 1 --final-pairs 1 --json");
  expect("drill chaser --drill 3,10 --trials 4 --json");
  expect("drill libero --drill 3 --trials 4 --without race --json");
  expect("check-team chaser --quick --json");
  expect("serve --no-referee --seconds 0.1 --interface 127.0.0.1 --port-base 19871 --json");
  for (const std::string file : {"a", "t", "cut"}) expect("replay info " + file + ".fbr --json");
  expect("replay events t.fbr --json");
  expect("replay verify . --json");
  expect("replay diff a.fbr b.fbr --json");
  expect("replay cut a.fbr c.fbr --plays 1 --json");
  expect("replay repair cut.fbr r.fbr --json");
  expect("replay send a.fbr --to 0.1 --speed 20 --port-base 52311 --interface 127.0.0.1 --json");
  expect("replay export a.fbr --jsonl -");
  expect("replay export t.fbr --jsonl -");
  expect("rules compare vsss-3v3 league-program-2021 a.fbr b.fbr --json --list");
  expect("bench --repetitions 1 --episodes 1 --json");
  expect("version --json");
}

TEST_CASE("parameters' defaults are listed in the type of their values", "[cli]") {
  const Sandbox box;
  const Json navigators = Json::parse(box.run("list navigators --json").out)["navigators"];
  int numbers = 0;
  for (const Json& navigator : navigators) {
    for (const Json& parameter : navigator["parameters"]) {
      INFO(parameter.dump());
      const std::string type = parameter["type"];
      const Json& value = parameter["default"];
      CHECK(value.is_number() == (type == "number" || type == "integer"));
      CHECK(value.is_boolean() == (type == "flag"));
      CHECK(value.is_string() == (type == "choice"));
      numbers += value.is_number() ? 1 : 0;
    }
  }
  CHECK(numbers > 20);
}
