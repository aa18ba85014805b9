#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

TEST_CASE("wrong words are usage errors with a suggestion, and say nothing on stdout", "[cli]") {
  const Sandbox box;
  const auto expect = [&](const std::string& arguments, const std::string& part) {
    box.fails(arguments, 2, part);
  };
  expect("", "subcommand");
  expect("comapre", "there is no command 'comapre'. Did you mean 'compare'?");
  expect("compare --trails 3", "Did you mean '--trials'?");
  expect("compare --suite cornr", "Did you mean 'corner'?");
  expect("compare --suite corner --navigators bezir",
         "there is no navigator 'bezir'. Did you mean 'bezier'?");
  expect("compare --suite corner --navigators bezier:clearance=9",
         "parameter 'clearance': '9' is not a number from");
  expect("compare --suite corner --navigators bezier:clearance", "is not of the form name=value");
  expect("compare --suite corner --trials abc", "--trials");
  expect("compare --suite corner --trials -4", "--trials");
  expect("compare --suite corner --speeds 99", "--speeds: 99 is outside");
  expect("compare --suite corner --jobs -1", "--jobs");
  expect("compare --suite corner --pictures -1", "--pictures: -1 is outside");
  expect("compare --suite corner --tune tangent-field --tune-evaluations 0 --out o",
         "--tune-evaluations: 0 is outside");
  expect("compare --suite corner --tune straight --out o", "has no numeric parameter to tune");
  expect("run --robot vss", "Did you mean 'vsss'?");
  expect("run --physics standrad", "Did you mean 'standard'?");
  expect("run --layout corner:x", "is not a layout number");
  expect("run --layout cornr:3", "Did you mean 'corner'?");
  expect("run --speed nan", "speed");
  expect("run --speed 0", "speed: 0 is outside");
  expect("run --noise -1", "noise: -1 is outside");
  expect("list navigatrs", "Did you mean 'navigators'?");
  expect("show robot vss", "Did you mean 'vsss'?");
  expect("show robt vsss", "Did you mean 'robot'?");
  expect("show robot", "name");
}

TEST_CASE("bad input files are named with line and key", "[cli]") {
  const Sandbox box;
  box.write("broken.toml", "name = \"x\"\n[start\n");
  Output output = box.run("run --layout broken.toml");
  CHECK(output.code == 3);
  CHECK(contains(output.err, "broken.toml:2"));
  box.write("range.toml", "[robot]\nname = \"r\"\nmass = -1.0\n");
  output = box.run("run --robot range.toml");
  CHECK(output.code == 3);
  CHECK(contains(output.err, "range.toml:3"));
  CHECK(contains(output.err, "mass"));
  output = box.run("run --layout missing.toml");
  CHECK(output.code == 5);
  CHECK(contains(output.err, "missing.toml"));
  box.write("deep.toml", "a = " + std::string(100000, '['));
  CHECK(box.run("run --layout deep.toml").code == 3);
  box.write("binary.toml", std::string("\0\xff\x01\x80", 4));
  CHECK(box.run("run --layout binary.toml").code == 3);
  output = box.run("run --layout /");
  CHECK(output.code == 5);
}

TEST_CASE("a file may go beside the folder that its command makes", "[cli]") {
  const Sandbox box;
  const std::string command =
      "compare --suite corner --navigators bezier --trials 1 --speeds 1 --pictures 1 --out new/a/first";
  for (const std::string page : {"new/a/races.html", "new/other.html"}) {
    fs::remove_all(box.path / "new");
    const Output output = box.run(command + " --html " + page);
    INFO(output.err);
    CHECK(output.code == 0);
    CHECK(fs::exists(box.path / page));
  }
  CHECK(box.run(command + " --html elsewhere/races.html").code == 5);
}

TEST_CASE("an output folder that cannot be written is found before work begins", "[cli]") {
  const Sandbox box;
  box.write("file", "x");
  box.fails("compare --suite corner --navigators bezier --trials 1 --speeds 1 --out file/below", 5,
            "file/below");
  CHECK(box.run("run --png no/such/folder/x.png").code == 5);
  CHECK(box.run("run --trace no/such/folder/x.csv").code == 5);
  CHECK(std::distance(fs::directory_iterator(box.path), {}) == 1);
}

TEST_CASE("run prints a score, writes a picture and a trace", "[cli]") {
  const Sandbox box;
  Output output = box.run("run --navigator bezier --layout corner:3 --png way.png --trace t.csv");
  CHECK(output.code == 0);
  CHECK(output.out.find("bezier on corner-3 at 1.00 m/s (seed 2015): reached") == 0);
  CHECK(contentOf(box.path / "way.png").substr(1, 3) == "PNG");
  const std::string trace = contentOf(box.path / "t.csv");
  CHECK(trace.starts_with("tick,time_s,x_m,y_m,heading_rad,"));
  CHECK(std::count(trace.begin(), trace.end(), '\n') > 60);
  output = box.run("run --layout fig6-two-turns --navigator limit-cycle --png --json");
  CHECK(output.code == 0);
  const Json json = Json::parse(output.out);
  CHECK(json["schema_version"] == 1);
  CHECK(json["navigator"] == "limit-cycle");
  CHECK(json["score"].contains("outcome"));
  CHECK(fs::exists(box.path / "fig6-two-turns.png"));
}

TEST_CASE("a layout of one's own is driven", "[cli]") {
  const Sandbox box;
  const Output shown = box.run("show case fig1-abrupt-turns");
  REQUIRE(shown.code == 0);
  box.write("mine.toml", shown.out);
  const Output named = box.run("run --layout fig1-abrupt-turns --json"),
               own = box.run("run --layout mine.toml --json");
  REQUIRE(own.code == 0);
  CHECK(Json::parse(own.out)["final_hash"] == Json::parse(named.out)["final_hash"]);
}

TEST_CASE("compare prints tables, and one layout again with --only", "[cli]") {
  const Sandbox box;
  const Output output =
      box.run("compare --suite short --navigators bezier --speeds 1 --trials 20 --only 17 --out o");
  CHECK(output.code == 0);
  CHECK(contains(output.out, "### short at 1.0 m/s, 1 layout"));
  CHECK(fs::exists(box.path / "o/short-17-1.0.png"));
}

TEST_CASE("compare --map writes the map as text, CSV, JSON and pictures", "[cli]") {
  const Sandbox box;
  const std::string command =
      "compare --map --suite close-range --speeds 1.0 --radii 0.06,0.1 --widths 0.2 --laws classic "
      "--headings goal --trials 2 --seeds 2 --fresh 1 --out one ";
  const Output text = box.works(command), json = box.works(command + "--json");
  CHECK(contains(text.out, "### Cells that match both of the paper's figures"));
  CHECK(Json::parse(json.out)["cells"].size() == 2);
  CHECK(box.read("one/map.json") == json.out);
  CHECK(std::distance(fs::directory_iterator(box.path / "one"), {}) == 3);
  box.fails("compare --map --radii 2 --out o", 2, "--radii: 2 is outside 0 ... 1 m");
  box.fails("compare --map --navigators bezier --out o", 2, "--map");
  box.fails("compare --radii 0.1 --out o", 2, "--map");
  CHECK_FALSE(fs::exists(box.path / "o"));
}

TEST_CASE("list and show print every kind, as text and JSON", "[cli]") {
  const Sandbox box;
  for (const char* kind : {"teams", "navigators", "suites", "cases", "robots", "physics", "fields"}) {
    const Output text = box.run(std::string("list ") + kind),
                 json = box.run(std::string("list ") + kind + " --json");
    CHECK(text.code == 0);
    CHECK(Json::parse(json.out)[kind].size() >= 3);
  }
  int defaults = 0;
  const Json listed = Json::parse(box.run("list navigators --json").out);
  for (const Json& n : listed["navigators"]) defaults += n["default"].get<bool>() ? 1 : 0;
  CHECK(defaults == 1);
  CHECK(contains(box.run("show robot vsss").out, "[robot]"));
  CHECK(contains(box.run("show physics faithful").out, "substeps = 4"));
  CHECK(contains(box.run("show field vsss-5v5").out, "2.2"));
}

TEST_CASE("profiles of rules are listed, shown, and checked with file, line, key and range", "[cli]") {
  const Sandbox box;
  const Json listed = Json::parse(box.run("list rules --json").out);
  REQUIRE(listed["rules"].size() == 4);
  for (const Json& entry : listed["rules"]) {
    const std::string name = entry["name"];
    const Output shown = box.run("rules show " + name);
    CHECK(shown.code == 0);
    CHECK(shown.out == box.run("show rules " + name).out);
    box.write("mine.toml", shown.out);
    CHECK(box.run("rules check mine.toml").code == 0);
  }
  box.write("bad.toml", "[rules]\n[periods]\nhalf_seconds = -1\n");
  box.fails("rules check bad.toml", 3, "bad.toml:3: periods.half_seconds = -1 is outside 0.1 ... 7200 s");
  box.write("odd.toml", "[rules]\n[goal_kick]\ntaker = [[0.0, 0.0]]\n");
  CHECK(contains(box.run("rules check odd.toml").out, "note: goal-kick: robot 0"));
  CHECK(box.run("rules check nowhere.toml").code == 5);
  CHECK(box.run("rules").code == 2);
  CHECK(contains(box.run("rules").err, "show NAME, check FILE"));
  CHECK(contains(box.run("rules show vsss-3v4").err, "Did you mean 'vsss-3v3'?"));
}

TEST_CASE("version tells what it was built from", "[cli]") {
  const Sandbox box;
  const Json json = Json::parse(box.run("version --json").out);
  CHECK(json["box2d"] == "2.4.1");
  CHECK(json.contains("compiler"));
  CHECK(box.run("version").out.starts_with("fulbito "));
}

TEST_CASE("bench prints the signature of its fixed scenes, the same every time", "[cli]") {
  const Sandbox box;
  const Output first = box.run("bench --signature"), again = box.run("bench --signature");
  CHECK(first.code == 0);
  CHECK(first.out == again.out);
  CHECK(first.out.size() == 17);
}
