// What the machine lacks: exit code 6 and the reason, never a crash and never a team's fault.

#include <string>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

const std::string kTeam = FULBITO_TEST_LIBRARIES "/ported_chaser.so";

}  // namespace

TEST_CASE("a team that the machine cannot run is not judged", "[cli]") {
  const Sandbox box;
  for (const std::string limit : {"-n 18", "-s 512", "-v 700000", "-f 4000"}) {
    for (const std::string& command :
         {"check-team " + kTeam + " --quick", "match idle " + kTeam, "sprt " + kTeam + " idle --pairs 4",
          "drill " + kTeam + " --drill 3 --trials 2 --check",
          "tournament run idle " + kTeam + " --half-seconds 1 --out t"}) {
      INFO(limit << "; " << command);
      const Output output = box.shell("ulimit " + limit + "; $F " + command);
      CHECK(output.code == 6);
      CHECK(output.out.empty());
      CHECK_THAT(output.err,
                 Catch::Contains("fulbito: ") && (Catch::Contains("ulimit " + limit.substr(0, 2)) ||
                                                  Catch::Contains("Too many open files")));
    }
  }
}

TEST_CASE("a smaller promise lets a smaller machine play", "[cli]") {
  const Sandbox box;
  const Output output = box.shell("ulimit -v 700000; ulimit -n 40; $F match " + kTeam +
                                  " idle --half-seconds 1 --team-memory 200");
  INFO(output.err);
  CHECK(output.code == 0);
}

TEST_CASE("whatever stack and memory the shell leaves, the program says so or does its work", "[cli]") {
  const Sandbox box;
  box.works("match chaser libero --half-seconds 2 --record a.fbr");
  for (const std::string stack : {"ulimit -s 48", "ulimit -s 300"}) {
    INFO(stack);
    CHECK(box.shell(stack + "; $F match chaser libero --half-seconds 1 -n 2 --jobs 3").code == 0);
    CHECK(box.shell(stack + "; $F replay export a.fbr --gif a.gif --size 400 --to 1 --force").code == 0);
  }
  for (const int memory : {50'000, 57'000, 70'000, 90'000, 130'000}) {
    const std::string limit = "ulimit -v " + std::to_string(memory) + "; $F ";
    for (const std::string command :
         {"match random chaser -n 5 --half-seconds 1 --jobs 40",
          "replay export a.fbr --gif b.gif --size 400 --to 1 --force",
          "tournament run idle chaser random --half-seconds 1 --jobs 40 --out t"}) {
      const Output output = box.shell(limit + command);
      INFO(memory << " " << command << ": " << output.err);
      CHECK((output.code == 0 || output.code == 6));
      CHECK((output.code == 0 || !output.err.empty()));
    }
  }
}

TEST_CASE("where descriptors lack for files, each command says so by the same code", "[cli]") {
  const Sandbox box;
  box.works("match chaser idle --half-seconds 1 --record a.fbr");
  box.works("tournament run idle random --half-seconds 1 --pairs 1 --out whole");
  int lacking = 0;
  for (const std::string command :
       {"tournament run idle random --half-seconds 1 --pairs 1 --out t --jobs 1",
        "tournament run idle random --half-seconds 1 --pairs 1 --out u --cache c --jobs 1",
        "tournament report whole --csv a.csv --html a.html", "tournament merge whole --out m",
        "match idle random --half-seconds 1 --record b.fbr --force", "replay verify a.fbr", "replay verify .",
        "replay export a.fbr --jsonl a.jsonl --force", "sprt idle random --pairs 2 --half-seconds 1 --out s",
        "run --png way.png --force"}) {
    INFO(command);
    const Output output = box.shell("exec 3</dev/null 4</dev/null; ulimit -n 6; $F " + command);
    INFO(output.err << output.out);
    const bool is_told = output.code == 6 && contains(output.err + output.out, "Too many open files");
    CHECK((output.code == 0 || is_told));
    lacking += is_told ? 1 : 0;
  }
  CHECK(lacking >= 3);
}

TEST_CASE("a signal while a team starts ends the command", "[cli]") {
  const Sandbox box;
  for (const std::string command : {"match 'cmd:sleep 60' idle", "check-team 'cmd:sleep 60'"}) {
    for (const auto& [signal, code] : {std::pair("INT", 130), std::pair("TERM", 143)}) {
      INFO(command << " " << signal);
      const Output output = box.shell("set -m; $F " + command + " & sleep 0.5; kill -" + signal +
                                      " $!; begin=$SECONDS; wait $!; echo $? $((SECONDS - begin))");
      int ended = 0, seconds = 0;
      std::istringstream(output.out) >> ended >> seconds;
      CHECK(ended == code);
      CHECK(seconds < 4);
      CHECK(output.err.find("no start") == std::string::npos);
    }
  }
}
