#include <csignal>
#include <sys/stat.h>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/json_lines.hpp"

using namespace fulbito::test;

namespace {

/// Runs the command, sends it the signal after `wait`, a script, and gives its exit code and how long it went
/// on.
struct Ended {
  int code = 0;
  double seconds = 0.0;  ///< from the signal on
};

Ended signalled(const Sandbox& box, const std::string& command, const char* signal,
                const std::string& wait = "sleep 0.3") {
  // A shell's background process ignores Ctrl-C until the program has its handlers.
  const std::string ready =
      "for i in {1..2000}; do grep -q '^SigCgt:.*[2367abef]$' /proc/$p/status && [ /proc/$p/exe -ef \"$F\" ] "
      "&& break; sleep 0.01; done; ";
  const Output output =
      box.shell("$F " + command + " > said.txt 2>&1 & p=$!; " + ready + wait + "; s=$(date +%s%N); kill -" +
                signal + " $p; wait $p; c=$?; echo $c $((($(date +%s%N) - s) / 1000000))");
  Ended ended;
  double milliseconds = 0.0;
  std::istringstream(output.out) >> ended.code >> milliseconds;
  ended.seconds = milliseconds / 1000.0;
  return ended;
}

constexpr double kSoon = 6.0;  // [s] more than the few seconds that work has to end by itself

}  // namespace

TEST_CASE("one signal ends any work soon, with the exit code of that signal", "[cli]") {
  const Sandbox box;
  box.works("match libero classic --half-seconds 150 --record long.fbr");
  struct Case {
    const char* command;
    const char* signal;
    int code;
  };
  for (const Case& c : {Case{"bench", "INT", 130}, Case{"bench", "TERM", 143}, Case{"bench", "HUP", 129},
                        Case{"match libero libero --half-seconds 3000", "TERM", 143},
                        Case{"match libero libero --half-seconds 3000 -n 50", "HUP", 129},
                        Case{"drill libero --trials 5000", "TERM", 143},
                        Case{"compare --suite corner --trials 20000 --out o", "HUP", 129},
                        Case{"compare --suite corner --tune limit-cycle --jobs 1 --out o", "INT", 130},
                        Case{"replay export long.fbr --trails --size 8000 --force", "INT", 130},
                        Case{"replay export long.fbr --gif long.gif --force", "TERM", 143}}) {
    INFO(c.command << " " << c.signal);
    const Ended ended = signalled(box, c.command, c.signal);
    CHECK(ended.code == c.code);
    CHECK(ended.seconds < kSoon);
    // A match and a series tell what they have; all else says so, whoever ends it.
    const std::string said = box.shell("cat said.txt").out;
    CHECK((contains(said, "interrupted") || contains(said, "stopped early") ||
           contains(said, "no pair was finished")));
  }
  for (const auto& entry : fs::directory_iterator(box.path)) CHECK_FALSE(contains(entry.path(), ".tmp"));
  CHECK(fs::is_empty(box.path / "o"));
}

TEST_CASE("playing again ends on a signal: verify, cut, rules compare, html", "[cli]") {
  const Sandbox box;
  box.works("match libero libero --half-seconds 600 --record a.fbr --recipe");
  for (const std::string command :
       {"replay verify a.fbr", "replay cut a.fbr c.fbr --from 0", "rules compare vsss-3v3 training a.fbr",
        "replay export a.fbr --html a.html"}) {
    INFO(command);
    const Ended ended = signalled(box, command, "TERM", "sleep 0.15");
    CHECK(ended.code == 143);
    CHECK(ended.seconds < kSoon);
  }
  CHECK_FALSE(fs::exists(box.path / "c.fbr"));
  CHECK_FALSE(fs::exists(box.path / "a.html"));
}

TEST_CASE("a signal ends waiting for a pipe", "[cli]") {
  const Sandbox box;
  box.works("match chaser chaser --half-seconds 2 --record a.fbr");
  REQUIRE(::mkfifo((box.path / "pipe").c_str(), 0600) == 0);
  for (const std::string command :
       {"replay info pipe", "match --rules pipe", "match --start pipe", "run --layout pipe",
        "run --robot pipe", "run --png pipe", "replay export a.fbr --csv pipe",
        "match chaser chaser --half-seconds 1 --record pipe", "view pipe"}) {
    INFO(command);
    const Ended ended = signalled(box, command, "INT");
    CHECK(ended.code == 130);
    CHECK(ended.seconds < kSoon);
  }
}

TEST_CASE("a signal ends waiting for ffmpeg, which does not stay behind", "[cli]") {
  const Sandbox box;
  box.works("match chaser chaser --half-seconds 10 --record a.fbr");
  fs::create_directory(box.path / "bin");
  box.write("bin/ffmpeg", "#!/bin/sh\necho $$ > '" + (box.path / "pid").string() + "'\nexec sleep 100\n");
  fs::permissions(box.path / "bin/ffmpeg", fs::perms::owner_all);
  for (const char* ending : {"mp4", "webm"}) {
    const std::string name = std::string("film.") + ending;
    const Output output =
        box.shell("PATH=" + (box.path / "bin").string() + ":$PATH; $F replay export a.fbr --" + ending + " " +
                  name + " & p=$!; sleep 0.5; kill -TERM $p; wait $p; echo $?; " +
                  "sleep 0.2; grep -q '^State:.[^Z]' /proc/$(cat pid)/status && echo alive; ls");
    CHECK(output.out.starts_with("143\n"));
    CHECK_FALSE(contains(output.out, "alive"));
    CHECK_FALSE(contains(output.out, "film"));
  }
  // A second signal ends it at once, as clean.
  const Output twice =
      box.shell("PATH=" + (box.path / "bin").string() +
                ":$PATH; $F replay export a.fbr --mp4 f.mp4 & p=$!; sleep 0.5; kill -INT $p; "
                "kill -INT $p; wait $p; echo $?; sleep 0.2; grep -q '^State:.[^Z]' /proc/$(cat pid)/status "
                "&& echo alive; ls");
  CHECK(twice.out.starts_with("130\n"));
  CHECK_FALSE(contains(twice.out, "alive"));
  CHECK_FALSE(contains(twice.out, "f.mp4"));
}

TEST_CASE("a signal finishes the recording and the events of a match, and a series tells what it has",
          "[cli]") {
  for (const auto& [signal, code] : {std::pair{"HUP", 129}, std::pair{"INT", 130}}) {
    const Sandbox box;
    INFO(signal);
    const std::string match = "match chaser chaser --half-seconds 3600 --record a.fbr --events e.jsonl";
    CHECK(signalled(box, match, signal, "until [ -s a.fbr ] && [ -s e.jsonl ]; do sleep 0.01; done").code ==
          code);
    CHECK(contains(box.read("said.txt"), "stopped early"));
    CHECK(contains(box.works("replay verify a.fbr").out, "identical, bit for bit"));
    const Json last = jsonLines(box.read("e.jsonl")).back();
    CHECK(last["event"] == "end");
    CHECK(last["complete"] == false);
    const std::string series = "match chaser chaser --half-seconds 1 -n 100000 --json --jobs 1 --out kept";
    // So that whole pairs are there on any machine.
    const std::string played =
        "until [ \"$(cat kept/matches.jsonl 2>/dev/null | wc -l)\" -gt 4 ]; do sleep 0.01; done";
    CHECK(signalled(box, series, signal, played).code == code);
    const std::string said = box.read("said.txt");  // with notes
    const Json json = Json::parse(said.substr(said.find('{'), said.rfind('}') + 1 - said.find('{')));
    CHECK(json["complete"] == false);
    CHECK(json["pairs"] > 0);
    CHECK(json["matches"].size() == 2 * json["pairs"].get<std::size_t>());
  }
}

TEST_CASE("who must not hear that the terminal closes does not", "[cli]") {
  const Sandbox box;
  const Output output = box.shell(
      "nohup $F match chaser chaser --half-seconds 100 --json > j.txt 2>/dev/null & p=$!;"
      " sleep 0.1; kill -HUP $p; wait $p; echo $?");
  CHECK(output.out == "0\n");
}
