#include <sys/stat.h>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

const std::string kMatch = "match chaser chaser --half-seconds 2 ";

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("outputs go into a pipe, which stays one", "[cli]") {
  const Sandbox box;
  box.works(kMatch + "--record a.fbr");
  REQUIRE(::mkfifo((box.path / "pipe").c_str(), 0600) == 0);
  for (const std::string command :
       {"run --png pipe", "replay export a.fbr --png pipe", "replay export a.fbr --csv pipe",
        "replay export a.fbr --html pipe", "match chaser chaser --half-seconds 1 --record pipe"}) {
    INFO(command);
    const Output output = box.shell("cat pipe > through.txt & $F " + command + "; code=$?; wait; exit $code");
    CHECK(output.code == 0);
    CHECK(fs::is_fifo(box.path / "pipe"));
    CHECK(fs::file_size(box.path / "through.txt") > 100);
  }
  CHECK(filesIn(box.path) == 3);
}

TEST_CASE("the way to a picture leads over nobody's file or link", "[cli]") {
  const Sandbox box;
  box.write("victim", "precious");
  fs::create_symlink("victim", box.path / "x.png.part");
  CHECK(box.run("run --png x.png").code == 0);
  CHECK(contentOf(box.path / "victim") == "precious");
  CHECK_FALSE(fs::is_symlink(box.path / "x.png"));
}

TEST_CASE("results that nobody gets are an error of every command", "[cli]") {
  const Sandbox box;
  box.works(kMatch + "--record a.fbr");
  for (const std::string command : {"match chaser chaser --half-seconds 1",
                                    "match chaser chaser --half-seconds 1 --json",
                                    "match chaser chaser --half-seconds 1 -n 1 --json",
                                    "replay info a.fbr --json",
                                    "replay info a.fbr",
                                    "replay events a.fbr",
                                    "replay events a.fbr --json",
                                    "replay verify a.fbr",
                                    "replay diff a.fbr a.fbr --json",
                                    "rules show vsss-3v3",
                                    "rules check vsss-3v3",
                                    "rules compare vsss-3v3 training a.fbr",
                                    "run --json",
                                    "run --trace -",
                                    "show robot vsss",
                                    "version",
                                    "--help",
                                    "match --help",
                                    "--version",
                                    "list teams --json",
                                    "bench --signature",
                                    "drill --list",
                                    "replay export a.fbr --csv -",
                                    "replay export a.fbr --html -",
                                    "match chaser chaser --half-seconds 1 --events -"}) {
    INFO(command);
    const Output full = box.shell("$F " + command + " > /dev/full");
    CHECK(full.code == 5);
    CHECK(contains(full.err, "cannot write to stdout"));
    CHECK(box.shell("$F " + command + " >&-").code == 5);
  }
}

TEST_CASE("a reader that has gone is told quietly, and a full disk is an error of writing", "[cli]") {
  const Sandbox box;
  // More than a buffer's worth, so that it is written before the end.
  CHECK(box.shell("(sleep 0.2; $F list navigators; echo code $? >&2) | true").err == "code 5\n");
  const Output full = box.shell("$F list navigators > /dev/full");
  CHECK(full.code == 5);
  CHECK(full.err == "fulbito: cannot write to stdout: No space left on device\n");
}

TEST_CASE("files do not get the numbers of closed descriptors", "[cli]") {
  const Sandbox box;
  CHECK(box.shell("$F " + kMatch + "--events e.jsonl --record a.fbr >&- 2>&- <&-").code == 5);
  std::ifstream lines(box.path / "e.jsonl");
  for (std::string line; std::getline(lines, line);) CHECK(Json::accept(line));
  CHECK(box.run("replay verify a.fbr").code == 0);
  CHECK(box.shell("$F replay export a.fbr --csv c --png p --gif g 2>&- >&-").code == 0);
  CHECK(fs::file_size(box.path / "g") > 100);
  CHECK(box.shell("$F compare --suite corner --trials 1 --out o >&- 2>&-").code == 5);
  CHECK(fs::exists(box.path / "o/results.json"));
}

TEST_CASE("no output takes the place of an input or of another output", "[cli]") {
  const Sandbox box;
  box.works(kMatch + "--record a.fbr");
  for (const auto& [file, command] :
       {std::pair{"rules.toml", "rules show training"}, std::pair{"robot.toml", "show robot vsss"},
        std::pair{"layout.toml", "show case fig1-abrupt-turns"}}) {
    box.write(file, box.run(command).out);
  }
  fs::create_hard_link(box.path / "a.fbr", box.path / "same.fbr");
  const std::string before = contentOf(box.path / "a.fbr"), rules = contentOf(box.path / "rules.toml");
  for (const std::string& command :
       {kMatch + "--rules rules.toml --events rules.toml",
        kMatch + "--robot robot.toml --record ./robot.toml", kMatch + "--record b --events b",
        std::string("run --layout layout.toml --record layout.toml"),
        std::string("run --layout layout.toml --png layout.toml"),
        std::string("run --layout layout.toml --trace layout.toml"),
        std::string("run --png q --record q --trace q"), std::string("view a.fbr --screenshot a.fbr"),
        std::string("compare --suite corner --trials 1 --out cc --html cc/results.json"),
        std::string("compare --suite corner --trials 1 --out cc --html cc/a.png"),
        std::string("replay cut a.fbr a.fbr --plays 1"), std::string("replay repair a.fbr a.fbr"),
        std::string("replay export a.fbr --csv a.fbr"), std::string("replay export a.fbr --gif same.fbr"),
        std::string("replay export a.fbr --html a.fbr"),
        std::string("replay export a.fbr --png b --gif b")}) {
    INFO(command);
    CHECK(box.run(command + " --force").code == 2);
  }
  CHECK(contentOf(box.path / "a.fbr") == before);
  CHECK(contentOf(box.path / "rules.toml") == rules);
  CHECK_FALSE(fs::exists(box.path / "b"));
  CHECK_FALSE(fs::exists(box.path / "q"));
}

TEST_CASE("files that exist are replaced with --force only", "[cli]") {
  const Sandbox box;
  box.works(kMatch + "--record a.fbr");
  for (const std::string& command : {kMatch + "--record x", kMatch + "--events x", std::string("run --png x"),
                                     std::string("run --record x"), std::string("run --trace x"),
                                     std::string("replay export a.fbr --html x"),
                                     std::string("compare --suite corner --trials 1 --out o --html x")}) {
    INFO(command);
    box.write("x", "old");
    box.fails(command, 2, "exists; use --force");
    CHECK(contentOf(box.path / "x") == "old");
    CHECK(box.run(command + " --force").code == 0);
    CHECK(fs::file_size(box.path / "x") > 10);
  }
}

TEST_CASE("a dash is no file where nothing goes to stdout", "[cli]") {
  const Sandbox box;
  for (const std::string& command :
       {std::string("run --png -"), std::string("run --record -"), kMatch + "--record -",
        std::string("compare --suite corner --trials 1 --html -"),
        std::string("view none.fbr --screenshot -")}) {
    INFO(command);
    box.fails(command, 2, "not to stdout");
    CHECK_FALSE(fs::exists(box.path / "-"));
  }
}

TEST_CASE("two recordings into one file at once: one is whole, the other refused", "[cli]") {
  const Sandbox box;
  const std::string two =
      "$F match chaser chaser --half-seconds 30 --seed 1 --record o.fbr & first=$!; "
      "$F match chaser chaser --half-seconds 30 --seed 2 --record o.fbr; second=$?; "
      "wait $first; echo $? $second";
  const Output output = box.shell(two);
  CHECK((contains(output.out, "\n0 2\n") || contains(output.out, "\n2 0\n")));
  CHECK(box.run("replay verify o.fbr").code == 0);
  const Output forced = box.shell(
      "$F match chaser chaser --half-seconds 20 --seed 1 --record o.fbr --force & first=$!; "
      "$F match chaser chaser --half-seconds 20 --seed 2 --record o.fbr --force; second=$?; "
      "wait $first; echo $? $second");
  CHECK(contains(forced.out, "\n0 0\n"));
  CHECK(box.run("replay verify o.fbr").code == 0);
}

TEST_CASE("a limit of the system on files is an error of writing that leaves nothing", "[cli]") {
  const Sandbox box;
  box.works(kMatch + "--record a.fbr");
  fs::create_directory(box.path / "out");
  for (const std::string command :
       {"replay export a.fbr --png out/p.png", "replay export a.fbr --gif out/g.gif",
        "replay export a.fbr --html out/h.html", "replay cut a.fbr out/c.fbr --plays 1",
        "run --png out/r.png", "match chaser chaser --half-seconds 2 --record out/m.fbr"}) {
    INFO(command);
    const Output output = box.shell("ulimit -f 1; $F " + command);
    CHECK(output.code == 5);
    CHECK(contains(output.err, "File too large"));
    CHECK(fs::is_empty(box.path / "out"));
  }
}
