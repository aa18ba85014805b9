#include <algorithm>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

std::size_t countOf(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find(word, at)) != std::string::npos; at += word.size()) ++count;
  return count;
}

}  // namespace

TEST_CASE("check-team passes a built-in team and writes JSON and JUnit", "[cli]") {
  const Sandbox box;
  const Output output = box.run("check-team classic --quick --json --junit check.xml");
  INFO(output.err << output.out);
  REQUIRE(output.code == 0);
  const Json json = Json::parse(output.out);
  CHECK(json["team"] == "classic");
  CHECK(json["verdict"] != "failed");
  REQUIRE(json["checks"].size() > 10);
  const std::string xml = contentOf(box.path / "check.xml");
  CHECK(xml.starts_with("<?xml"));
  CHECK(countOf(xml, "<testcase ") == json["checks"].size());
  CHECK(countOf(xml, "<testcase ") == countOf(xml, "</testcase>"));
  CHECK(contains(xml, "failures=\"0\""));
  if (box.shell("command -v xmllint").code == 0) CHECK(box.shell("xmllint --noout check.xml").code == 0);
}

TEST_CASE("check-team repeats its results but for the measured times", "[cli]") {
  const Sandbox box;
  const auto results = [&] {
    Json json = Json::parse(box.run("check-team chaser --quick --seed 5 --json").out);
    dropMeasured(json);
    // On a busy machine a decision may take long enough for a warning.
    json.erase("verdict");
    Json& checks = json["checks"];
    for (Json& check : checks) {
      if (check["name"] != "time" && check["name"] != "start") continue;
      check.erase("finding");
      check.erase("verdict");
    }
    return json;
  };
  CHECK(results() == results());
}

TEST_CASE("check-team fails a program that ends during play, and says where", "[cli]") {
  const Sandbox box;
  // Answers hello and begin, and ends at the first decision.
  box.write("ends.py",
            "import sys\n"
            "import fulbito_team as ft\n"
            "class Ends(ft.Team):\n"
            "    def decide(self, seen):\n"
            "        sys.exit(9)\n"
            "ft.run(Ends())\n");
  const Output output = box.run("check-team 'cmd:python3 ends.py' --quick --junit check.xml");
  INFO(output.err << output.out);
  CHECK(output.code == 1);
  CHECK(contains(output.out, "verdict: failed"));
  CHECK(contains(output.out, "exit code 9"));
  // The protocol, and all three comparisons of answers.
  CHECK(countOf(contentOf(box.path / "check.xml"), "<failure message=") >= 4);
}

TEST_CASE("check-team refuses a team that does not start, with the reason", "[cli]") {
  const Sandbox box;
  box.fails("check-team cmd:false", 2, "exit code 1");
  CHECK(box.run("check-team classik").code == 2);
  box.write("there.xml", "kept");
  CHECK(box.run("check-team idle --quick --junit there.xml").code == 2);
  CHECK(contentOf(box.path / "there.xml") == "kept");
}
