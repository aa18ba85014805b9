#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

TEST_CASE("an empty value is refused everywhere", "[cli]") {
  const Sandbox box;
  for (const std::string command :
       {"match --half-seconds ''", "match -n ''", "match --start ''", "match --record ''",
        "match --events ''", "compare --trials ''", "replay export a.fbr --html ''",
        "replay export a.fbr --gif g --fps ''", "match --seed=", "match ''", "run --layout ''"}) {
    box.fails(command, 2, "empty");
  }
}

TEST_CASE("numbers are decimal in every flag", "[cli]") {
  const Sandbox box;
  const auto seed = [&](const std::string& text) {
    return Json::parse(box.run("match chaser chaser --half-seconds 1 --json --seed " + text).out)["seed"];
  };
  CHECK(seed("010") == 10);
  CHECK(seed("08") == 8);
  CHECK(Json::parse(box.run("match idle idle --half-seconds 01 -n 03 --json").out)["pairs"] == 3);
  const Output late = box.run("match idle idle --half-seconds 1 --latency 010 --json");
  CHECK(contains(late.out, "\"latency_ticks\": 10,"));
  for (const std::string command : {"match --seed 0x10",
                                    "match --latency 0x10",
                                    "match --half-seconds 0x10",
                                    "match -n 1e1",
                                    "match -n 0",
                                    "match --noise nan",
                                    "match --noise inf",
                                    "run --speed nan",
                                    "run --speed 1e400",
                                    "view a.fbr --from nan",
                                    "view a.fbr --from inf",
                                    "replay cut a.fbr b.fbr --from 0x1",
                                    "compare --trials 0",
                                    "compare --trials -1",
                                    "drill classic --jobs 20000",
                                    "drill classic --jobs -3",
                                    "match --jobs 20000",
                                    "compare --jobs 99999",
                                    "replay verify a.fbr --jobs -1",
                                    "replay export a.fbr --gif g --jobs 5000"}) {
    box.fails(command, 2, "number");
  }
}

TEST_CASE("flags that have no effect are refused", "[cli]") {
  const Sandbox box;
  box.works("match chaser chaser --half-seconds 2 --record a.fbr");
  for (const std::string command :
       {"replay export a.fbr --csv - --ghost none", "replay export a.fbr --csv - --theme light",
        "replay export a.fbr --html h --at 1", "replay export a.fbr --heatmap ball --trail 2",
        "replay export a.fbr --gif g --quality 3", "run --trace - --json",
        "compare --suite corner --trials 1 --tune-evaluations 3", "view a.fbr --from -1 --frames 1",
        "view a.fbr --from 1e308 --frames 1"}) {
    INFO(command);
    CHECK(box.run(command).code == 2);
  }
}

TEST_CASE("what a match refuses the check of rules refuses too", "[cli]") {
  const Sandbox box;
  box.write("rules.toml", box.run("rules show vsss-3v3").out);
  std::string rules = contentOf(box.path / "rules.toml");
  rules.replace(rules.find("field = \"vsss-3v3\""), 18, "field = \"./f.toml\"");
  box.write("rules.toml", rules);
  const std::string field = box.run("show field vsss-3v3").out;
  const auto with = [&](const std::string& key, const std::string& value) {
    std::string changed = field;
    const std::size_t at = changed.find("\n" + key + " = ") + 1;
    changed.replace(at, changed.find('\n', at) - at, key + " = " + value);
    box.write("f.toml", changed);
  };
  for (const auto& [key, value, said] :
       {std::tuple{"goal_width", "0.0", "no goals"}, std::tuple{"goal_width", "1e-12", "f.toml:"},
        std::tuple{"goal_width", "0.03", "narrower than the ball"},
        std::tuple{"length", "0.3", "is not inside"}}) {
    with(key, value);
    const Output check = box.run("rules check rules.toml");
    const Output match = box.run("match chaser classic --half-seconds 1 --rules rules.toml");
    INFO(key << " " << value << ": " << check.err << match.err);
    CHECK(check.code == 3);
    CHECK(match.code == 3);
    CHECK(contains(check.err, said));
    CHECK(contains(match.err, said));
    CHECK(match.out.empty());
  }
}

TEST_CASE("names of files may be any bytes", "[cli]") {
  const Sandbox box;
  std::string robot = box.run("show robot vsss").out;
  const std::size_t name = robot.find("name = ");
  robot.erase(name, robot.find('\n', name) - name + 1);
  std::string long_name = "a";
  for (int i = 0; i < 60; ++i) long_name += "é";
  for (const std::string& file : {long_name + ".toml", std::string("no\xff\xfeutf.toml")}) {
    box.write(file, robot);
    for (const std::string command : {"match idle idle --half-seconds 1 --json --robot ./'",
                                      "drill classic --drill 1 --trials 1 --json --robot ./'"}) {
      const Output output = box.run(command + file + "'");
      CHECK(output.code == 0);
      CHECK(Json::accept(output.out));
    }
  }
  REQUIRE(box.shell("$F match chaser chaser --half-seconds 1 --record $'\\xff.fbr'").code == 0);
  const Output compared = box.shell("$F rules compare vsss-3v3 training $'\\xff.fbr' --list --json");
  INFO(compared.err << compared.out);
  CHECK(Json::accept(compared.out));
}

TEST_CASE("messages are short, whole and harmless", "[cli]") {
  const Sandbox box;
  const Output esc = box.shell("$F replay info $'\\x1b[31m\\x07.fbr'");
  CHECK(esc.code == 5);
  CHECK_FALSE(contains(esc.err, "\x1b"));
  CHECK(contains(esc.err, "\\x1b[31m"));
  const Output huge = box.shell("$F match $(printf '%0120000d' 7)");
  CHECK(huge.code == 2);
  CHECK(huge.err.size() < 4000);
  box.works("match chaser chaser --half-seconds 1 --record a.fbr");
  std::string bytes = contentOf(box.path / "a.fbr");
  bytes[bytes.size() / 2] ^= 1;
  box.write("b.fbr", bytes);
  for (const std::string command :
       {"replay events b.fbr", "replay export b.fbr --csv -", "replay verify b.fbr"}) {
    const Output output = box.run(command);
    INFO(output.err);
    CHECK(output.code == 3);
    CHECK(output.err.find("b.fbr:") == output.err.rfind("b.fbr:"));
  }
  CHECK(box.shell("TERM=dumb timeout 20 $F replay info /dev/zero").code == 3);
}

TEST_CASE("where no thread starts or no memory is left the work is done, or the error said", "[cli]") {
  const Sandbox box;
  box.works("match chaser chaser --half-seconds 1 --record a.fbr");
  fs::permissions(box.path, fs::perms::all);
  const bool root = ::geteuid() == 0;
  const std::string nobody = root ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
  for (const std::string command :
       {"replay export a.fbr --gif g.gif --size 240 --to 2 --jobs 8 --force",
        "replay export a.fbr --png p.png --size 240 --fps 2 --jobs 8 --force",
        "match chaser chaser --half-seconds 1 -n 2 --jobs 8", "replay verify a.fbr a.fbr --jobs 8",
        "compare --suite corner --trials 2 --jobs 8 --out o",
        "drill classic --drill 1 --trials 2 --jobs 8"}) {
    for (const char* processes : {"1", "3"}) {
      INFO(command << " with " << processes);
      const Output output = box.shell("timeout 60 " + nobody + "bash -c \"ulimit -u " + processes +
                                      "; exec $F " + command + "\"");
      CHECK(output.code == 0);
    }
  }
  // In one thread and code of ours: libraries do not all look whether they were given memory.
  const Output large = box.shell("truncate -s 500M a.fbr; ulimit -v 200000; $F replay info a.fbr");
  CHECK(large.code == 6);
  CHECK(contains(large.err, "not enough memory"));
}

TEST_CASE("a drill whose balls miss is told in time", "[cli]") {
  const Sandbox box;
  fs::create_directory(box.path / "drills");
  std::string drill = contentOf(FULBITO_DRILLS "/10-keeper.toml");
  for (std::size_t at = 0; (at = drill.find("\ntoward = ", at)) != std::string::npos; ++at) {
    drill.replace(at + 1, drill.find('\n', at + 1) - at - 1, "toward = [[0.0, 0.0]]");
  }
  box.write("drills/10.toml", drill);
  const Output output = box.shell("timeout 60 $F drill idle --drills drills --trials 1");
  CHECK(output.code == 3);
  CHECK(contains(output.err, "no ball goes into the goal"));
}
