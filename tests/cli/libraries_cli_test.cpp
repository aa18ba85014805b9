#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

const std::string kNavigators = FULBITO_TEST_LIBRARIES "/navigators.so";

}  // namespace

TEST_CASE("navigators of a shared library are compared with the built-in ones", "[cli]") {
  const Sandbox box;
  fs::copy(kNavigators, box.path / "mine.so");
  const Output output =
      box.run("compare --navigators ./mine.so:path ./mine.so:timed:gain=0.6 bezier --trials 2");
  CHECK(output.code == 0);
  CHECK(contains(output.out, "| ./mine.so:path |"));
  CHECK(contains(output.out, "| ./mine.so:timed:gain=0.6 * |"));
}

TEST_CASE("teams drive with navigators of a shared library", "[cli]") {
  const Sandbox box;
  fs::copy(kNavigators, box.path / "mine.so");
  const std::string end = " chaser --half-seconds 5 --json";
  const Output own = box.run("match classic:navigator=./mine.so:path" + end);
  CHECK(own.code == 0);
  CHECK(Json::parse(own.out)["final_hash"] != Json::parse(box.run("match classic" + end).out)["final_hash"]);
  CHECK(box.run("match libero:navigator=./mine.so:timed:gain=0.7+follower=classic" + end).code == 0);
}

TEST_CASE("errors of a library of navigators name the file", "[cli]") {
  const Sandbox box;
  fs::copy(kNavigators, box.path / "mine.so");
  box.write("text.so", "no library");
  const auto check = [&](const std::string& specification, int code, const std::string& words) {
    const Output output = box.run("compare --navigators " + specification);
    INFO(output.err);
    CHECK(output.code == code);
    CHECK(contains(output.err, words));
  };
  check("./mine.so:none", 2, "the library './mine.so' has no navigator 'none'");
  check("./mine.so:path:gain=9", 2, "parameter 'gain'");
  check("./none.so:path", 5, "cannot read the library './none.so'");
  check("./text.so:path", 3, "cannot load the library './text.so'");
}

TEST_CASE("a library that ends the program is named, and the program does not say that all went well",
          "[cli]") {
  const Sandbox box;
  fs::copy(FULBITO_TEST_LIBRARIES "/ending.so", box.path / "ending.so");
  const auto end = [&](const std::string& how, const std::string& where, const std::string& isolation) {
    return box.run("match ./ending.so:how=" + how + ",where=" + where +
                   " idle --half-seconds 1 --record kept.fbr --force --isolate " + isolation);
  };
  const std::string named = "/ending.so' ends this program: ";
  for (const auto& [how, where] : {std::pair{"exit", "decide"},
                                   {"exit", "ready"},
                                   {"exit", "destroy"},
                                   {"quick-exit", "decide"},
                                   {"thread", "decide"}}) {
    INFO(how << " in " << where);
    const Output output = end(how, where, "none");
    CHECK(output.code == 4);
    const std::string by = how == std::string("thread") ? "a library ends this program: " : named;
    CHECK(contains(output.err, by + "it calls exit"));
  }
  for (const auto& [how, where] :
       {std::pair{"hard-exit", "decide"}, {"hard-exit", "destroy"}, {"last-exit", "ready"}}) {
    INFO(how << " in " << where);
    const Output output = end(how, where, "none");
    CHECK(output.code == 4);
    CHECK(contains(output.err, named + "it calls _exit"));
  }
  CHECK(end("child", "decide", "none").code == 0);  // that ends another process
  for (const auto& [how, words] : {std::pair{"abort", "signal 6 (Aborted)"}, {"crash", "signal 11 "}}) {
    const Output output = end(how, "decide", "none");
    CHECK(output.code >= 128);
    CHECK(contains(output.err, named + words));
  }
  // In a process of its own it forfeits.
  const Output apart = end("exit", "decide", "process");
  CHECK(apart.code == 0);
  CHECK(contains(apart.out, "exit code 0"));
}
