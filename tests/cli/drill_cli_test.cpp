#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/json_lines.hpp"

using namespace fulbito::test;

TEST_CASE("the skills that the help of drill leaves out are skills of libero", "[cli]") {
  const Sandbox box;
  const std::string help = box.run("drill --help").out, example = "fulbito drill libero --without ";
  const std::size_t at = help.find(example);
  REQUIRE(at != std::string::npos);
  const std::size_t begin = at + example.size();
  const std::string skills = help.substr(begin, help.find(' ', begin) - begin);
  CAPTURE(skills);
  CHECK(box.run("drill libero --without " + skills + " --drill 13 --trials 1").code == 0);
}

TEST_CASE("drill --without measures what skills are worth", "[cli]") {
  const Sandbox box;
  const Output text = box.run("drill libero --without race,spin --drill 13 --trials 8");
  CHECK(text.code == 0);
  CHECK(text.out.starts_with("## What skills of libero are worth (seed 1, robot vsss, physics standard)\n"));
  const Output json = box.run("drill libero:without=spin --without race --drill 13 --trials 8 --json");
  const Json report = Json::parse(json.out);
  CHECK(report["team"] == "libero:without=spin");
  CHECK(report["skills"].at(0)["team"] == "libero:without=spin+race");
  CHECK(report["skills"].at(0)["drills"].at(0)["count"] == 8);
}

TEST_CASE("drill --without refuses what it cannot measure", "[cli]") {
  const Sandbox box;
  const auto refused = [&](const std::string& arguments, const std::string& message) {
    const Output output = box.run("drill " + arguments + " --drill 3 --trials 2");
    INFO(output.err);
    CHECK(output.code == 2);
    CHECK(contains(output.err, message));
  };
  refused("chaser --without race", "chaser has no list of skills; these teams have one: libero");
  refused("libero --without squeez", "libero has no skill 'squeez'. Did you mean 'squeeze'?");
  refused("libero --without strike", "without=strike");  // the striker cannot do without it
  refused("libero classic --without race", "--without: works with one team only");
  refused("libero --without race --check", "--check");
}

TEST_CASE("list teams says what sparring teams are for", "[cli]") {
  const Sandbox box;
  int training = 0, validation = 0;
  const Json teams = Json::parse(box.run("list teams --json").out)["teams"];
  for (const Json& team : teams) {
    training += team["purpose"] == "training" ? 1 : 0;
    validation += team["purpose"] == "validation" ? 1 : 0;
  }
  CHECK(training >= 5);
  CHECK(validation >= 3);
  CHECK(contains(box.run("list teams").out, " (for validation)\n"));
}
