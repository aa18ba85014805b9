#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

const std::string kTiny =
    "tune classic:strike_speed=0.4 --half-seconds 4 --iterations 3 --pairs 2 --final-pairs 2";

}  // namespace

TEST_CASE("tune prints the way of the parameters and the tuned team, which plays", "[cli]") {
  const Sandbox box;
  const Output output = box.works(kTiny + " --png path.png");
  CHECK(contains(output.err, "not tuned, as they are no numbers: exchange, spin"));
  CHECK(contains(output.out, "3 of 3 iterations"));
  CHECK(contains(output.out, "strike_speed"));
  CHECK(contains(output.out, "support"));
  CHECK(contains(output.out, "2 pairs, Elo"));
  CHECK(contentOf(box.path / "path.png").starts_with("\x89PNG"));
  const std::size_t tuned = output.out.find("  classic:strike_speed=");
  REQUIRE(tuned != std::string::npos);
  const std::string team = output.out.substr(tuned + 2, output.out.find('\n', tuned) - tuned - 2);
  CHECK(box.run("match " + team + " idle --half-seconds 1").code == 0);
}

TEST_CASE("tune continues after a kill and a signal to the same end", "[cli]") {
  const Sandbox box;
  const std::string command =
      "tune classic --half-seconds 10 --iterations 4 --pairs 3 --final-pairs 2 --json --jobs 1";
  const Output whole = box.run(command);
  REQUIRE(whole.code == 0);
  const auto stopped = [&](const std::string& signal, const std::string& lines) {
    // Waits for a part of the matches, so that the signal comes in the middle on any machine.
    return box.shell("$F " + command + " --out kept >first.txt 2>&1 & p=$!\n" +
                     "until [ \"$(cat kept/matches.jsonl 2>/dev/null | wc -l)\" -ge " + lines +
                     " ]; do kill -0 $p || break; sleep 0.01; done\nkill -" + signal +
                     " $p; wait $p; echo $?");
  };
  CHECK(stopped("KILL", "4").out == "137\n");
  const Output terminated = stopped("INT", "9");
  CHECK((terminated.out == "130\n" || terminated.out == "0\n"));
  CHECK(fs::exists(box.path / "kept" / "tune.json"));
  const Output rest = box.run(command + " --out kept");
  CHECK(rest.code == 0);
  CHECK(rest.out == whole.out);
  CHECK(contains(box.run(command + " --out kept").err, "0 matches played, 28 were there already"));
}

TEST_CASE("tune refuses a folder with other settings and says what has changed", "[cli]") {
  const Sandbox box;
  box.works(kTiny + " --out kept");
  const Output other = box.run(kTiny + " --out kept --seed 8 --c-end 0.2");
  CHECK(other.code == 2);
  CHECK(contains(other.err, "seed: "));
  CHECK(contains(other.err, "c_end: 0.1 -> 0.2"));
}

TEST_CASE("tune starts from the values of the specification, within the given limits", "[cli]") {
  const Sandbox box;
  const Output output = box.works(
      "tune classic:support=0.8,spin=off --parameters support=:0.5:0.9,keeper_depth --half-seconds 2 "
      "--iterations 2 --pairs 1 --final-pairs 0 --json");
  const Json json = Json::parse(output.out);
  REQUIRE(json["parameters"].size() == 2);
  CHECK(json["parameters"][0]["start"] == 0.8);
  CHECK(json["parameters"][0]["maximum"] == 0.9);
  CHECK(json["finals"].empty());
  CHECK(json["tuned"].get<std::string>().starts_with("classic:support="));
  CHECK(contains(json["tuned"], ",spin=off,keeper_depth="));
}

TEST_CASE("tune takes the parameters of a library, or those that flags give to a program", "[cli]") {
  const Sandbox box;
  const std::string tiny = " --half-seconds 1 --iterations 1 --pairs 1 --final-pairs 1 --json";
  const Output library = box.run("tune " FULBITO_TEST_LIBRARIES "/plain_c.so --isolate none" + tiny);
  INFO(library.err);
  REQUIRE(library.code == 0);
  const Json parameters = Json::parse(library.out)["parameters"];
  REQUIRE(parameters.size() == 2);
  CHECK(parameters[1]["name"] == "offset");
  CHECK(parameters[1]["type"] == "integer");

  box.works("new-team python mine");
  const std::string program = "tune 'cmd:python3 mine/team.py :margin=0.1' --parameters margin";
  CHECK(contains(box.run(program + tiny).err, "margin=START:LOW:HIGH"));
  const Output tuned = box.run(program + "=:0:0.3" + tiny);
  INFO(tuned.err);
  REQUIRE(tuned.code == 0);
  CHECK(Json::parse(tuned.out)["tuned"].get<std::string>().starts_with("cmd:python3 mine/team.py :margin="));
}

TEST_CASE("tune refuses what cannot be tuned", "[cli]") {
  const Sandbox box;
  for (const std::string command :
       {"tune", "tune nobody", "tune idle", "tune classic --parameters suport",
        "tune classic --parameters spin", "tune classic --parameters support=0.5:0:1",
        "tune classic --parameters support,support", "tune classic --iterations 0", "tune classic --pairs 0",
        "tune classic --c-end 0", "tune classic --c-end 0.7", "tune classic --r-end nan",
        "tune classic --opponent nobody", "tune classic --latency 1,2"}) {
    box.fails(command, 2);
  }
}
