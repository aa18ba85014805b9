#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/json_lines.hpp"

using namespace fulbito::test;

namespace {

const std::string kQuick = "match chaser chaser --half-seconds 5 ";

/// Text without what is measured: the line of the speed.
std::string withoutSpeed(const std::string& text) {
  const std::size_t begin = text.find(" s simulated in"), end = text.find('\n', begin);
  return text.substr(0, begin) + text.substr(end);
}

}  // namespace

TEST_CASE("a match prints its summary, and with --profile the share of every stage", "[cli]") {
  const Sandbox box;
  const Output output = box.works(kQuick + "--seed 7 --profile");
  CHECK(output.err.empty());
  for (const char* part : {"chaser (blue) ", "seed 7", "possession", "shots (on goal)", "x real time",
                           "final hash", "strategies", "navigation", "physics", "referee", "recording"}) {
    INFO(part);
    CHECK(contains(output.out, part));
  }
}

TEST_CASE("a match of the default teams", "[cli]") {
  const Sandbox box;
  const Json json = Json::parse(box.run("match --half-seconds 2 --json").out);
  CHECK(json["teams"] == Json{{"blue", "libero"}, {"yellow", "classic"}});
  CHECK(json["config"]["rules"] == "vsss-3v3");
  CHECK(json["config"]["physics"] == "standard");
}

TEST_CASE("a match's JSON has its keys, and the same bytes for the same seed", "[cli]") {
  const Sandbox box;
  const Output output = box.run(kQuick + "--seed 7 --json");
  REQUIRE(output.code == 0);
  CHECK(output.err.empty());
  Json first = Json::parse(output.out), again = Json::parse(box.run(kQuick + "--seed 7 --json").out);
  for (const char* key : {"schema_version", "teams", "score", "events", "stats", "seed", "build",
                          "final_hash", "simulated_s", "x_realtime"}) {
    INFO(key);
    CHECK(first.contains(key));
  }
  CHECK(first["seed"] == 7);
  CHECK(first["simulated_s"].get<double>() >= 10.0);
  CHECK(first["x_realtime"].get<double>() > 0.0);
  dropMeasured(first);
  dropMeasured(again);
  CHECK(first.dump() == again.dump());
  const Json other = Json::parse(box.run(kQuick + "--seed 8 --json").out);
  CHECK(other["final_hash"] != first["final_hash"]);
  CHECK(withoutSpeed(box.run(kQuick + "--seed 7").out) == withoutSpeed(box.run(kQuick + "--seed 7").out));
}

TEST_CASE("who watches a match changes nothing in it", "[cli]") {
  const Sandbox box;
  const Json plain = Json::parse(box.run(kQuick + "--json").out);
  const Output watched = box.run(kQuick + "--json --profile --record m.fbr --events e.jsonl");
  REQUIRE(watched.code == 0);
  const Json json = Json::parse(watched.out);
  CHECK(json["final_hash"] == plain["final_hash"]);
  CHECK(json["compute_profile"]["physics_ns"].get<std::int64_t>() > 0);
  CHECK(fs::file_size(box.path / "m.fbr") > 1000);
  CHECK(jsonLines(contentOf(box.path / "e.jsonl")).size() == json["events"].size() + 2);
}

TEST_CASE("rules, physics, robot, vision and length of a match can be chosen", "[cli]") {
  const Sandbox box;
  const Output output = box.run(
      "match chaser chaser --rules vsss-5v5 --physics faithful --robot firasim --half-seconds 2 --latency "
      "3,5 "
      "--noise 0.001 --dropout 0.1 --json");
  REQUIRE(output.code == 0);
  const Json json = Json::parse(output.out);
  CHECK(json["config"]["rules"] == "vsss-5v5");
  CHECK(json["config"]["physics"] == "faithful");
  CHECK(json["config"]["robot"] == "firasim");
  CHECK(json["config"]["vision"]["blue"]["latency_ticks"] == 3);
  CHECK(json["config"]["vision"]["yellow"]["latency_ticks"] == 5);
  CHECK(json["config"]["vision"]["yellow"]["dropout"] == 0.1);
  CHECK(json["config"]["half_s"] == 2.0);
  CHECK(json["stats"]["blue"]["robots"].size() == 5);
  const Output shown = box.run("rules show vsss-3v3");
  box.write("mine.toml", shown.out);
  const Json preset = Json::parse(box.run(kQuick + "--json").out);
  const Json file = Json::parse(box.run(kQuick + "--rules mine.toml --json").out);
  CHECK(file["final_hash"] == preset["final_hash"]);
}

TEST_CASE("what a flag says of one team or of both is read as such", "[cli]") {
  const Sandbox box;
  const Output output = box.run("match --latency 2 idle idle --half-seconds 1 --json");
  REQUIRE(output.code == 0);  // the teams after a flag are no values of it
  CHECK(Json::parse(output.out)["config"]["vision"]["yellow"]["latency_ticks"] == 2);
  box.fails("match idle idle --half-seconds 1 --noise 0,0.01,0.02", 2, "--noise: takes one or two values");
  // The handicap of one team is kept in the recording.
  box.works("match idle idle --half-seconds 1 --dropout 0,0.25 --record game.fbr");
  const Output events = box.run("replay events game.fbr --json");
  REQUIRE(events.code == 0);
  const Json head = jsonLines(events.out).front();
  CHECK(head["config"]["vision"]["blue"]["dropout"] == 0.0);
  CHECK(head["config"]["vision"]["yellow"]["dropout"] == 0.25);
}

TEST_CASE("match --time limits decisions", "[cli]") {
  const Sandbox box;
  const Output ample = box.run("match chaser idle --half-seconds 1 --time 60000 --json");
  REQUIRE(ample.code == 0);
  CHECK(Json::parse(ample.out)["stats"]["blue"]["commands"]["late"] == 0);
  CHECK(box.run("match idle idle --time -1").code == 2);
  CHECK(box.run("match idle idle --half-seconds 1 --time 60000 -n 2 --json").code == 0);
  CHECK(box.run("match idle idle --half-seconds 1 --time unlimited").code == 0);
  CHECK(box.run("match idle idle --time soon").code == 2);
}

TEST_CASE("match --events - streams lines to stdout and moves the summary to stderr", "[cli]") {
  const Sandbox box;
  const Output output = box.run(kQuick + "--events -");
  REQUIRE(output.code == 0);
  const std::vector<Json> lines = jsonLines(output.out);
  REQUIRE(lines.size() >= 4);
  CHECK(lines.front()["event"] == "match");
  CHECK(lines[1]["kind"] == "kick-off");
  CHECK(lines.back()["event"] == "end");
  CHECK(contains(output.err, "final hash"));
}

TEST_CASE("a match begins from a given state", "[cli]") {
  const Sandbox box;
  box.write("start.toml",
            "[ball]\nposition = [0.6, 0.0]\nvelocity = [1.0, 0.0]\n"
            "[[robot]]\nteam = \"blue\"\nnumber = 0\nposition = [0.5, 0.0]\n"
            "[match]\nblue = 4\nyellow = 2\nperiod = 2\nplay_seconds = 3.0\n");
  const Output output = box.run("match idle idle --half-seconds 5 --start start.toml --json");
  REQUIRE(output.code == 0);
  const Json json = Json::parse(output.out);
  CHECK(json["events"][0]["kind"] == "given");
  CHECK(json["score"]["blue"] == 5);  // the ball was rolling into the goal
  CHECK(json["score"]["yellow"] == 2);
  CHECK(json["stats"]["play_s"].get<double>() == Approx(2.0).margin(0.1));
}

TEST_CASE("a match begins from a free ball that a user placed", "[cli]") {
  const Sandbox box;
  box.write("start.toml",
            "[ball]\nposition = [0.375, 0.4]\n"
            "[[robot]]\nteam = \"blue\"\nnumber = 1\nposition = [0.14, 0.4]\n"
            "[[robot]]\nteam = \"yellow\"\nnumber = 1\nposition = [0.61, 0.4]\nheading_deg = 180\n"
            "[match]\nrestart = \"free-ball\"\nteam = \"blue\"\n");
  const Output output =
      box.run("match libero chaser --half-seconds 5 --start start.toml --json --record free.fbr");
  REQUIRE(output.code == 0);
  const Json json = Json::parse(output.out);
  CHECK(json["events"][0]["kind"] == "free-ball");
  CHECK(json["events"][0]["team"] == "blue");
  CHECK(box.run("replay verify free.fbr").code == 0);
}

TEST_CASE("a series plays swapped pairs and says what they show", "[cli]") {
  const Sandbox box;
  const Json a = Json::parse(box.works("match chaser idle --half-seconds 3 -n 3 --json").out);
  for (const char* key : {"points_share", "points_share_low", "points_share_high", "goal_difference",
                          "goal_difference_low", "goal_difference_high", "wins", "draws", "losses"}) {
    INFO(key);
    CHECK(a.contains(key));
  }
  CHECK(a["pairs"] == 3);
  CHECK(a["matches"].size() == 6);
  CHECK(a["wins"].get<int>() + a["draws"].get<int>() + a["losses"].get<int>() == 6);
  // A match of the series alone: its seed, and the teams in the order of its leg.
  const Json& leg = a["matches"][3];
  const Json alone = Json::parse(box.run("match idle chaser --half-seconds 3 --json --seed " +
                                         std::to_string(leg["seed"].get<std::uint64_t>()))
                                     .out);
  CHECK(alone["final_hash"] == leg["final_hash"]);
  const Output text = box.works("match chaser chaser --half-seconds 1 --pairs 2");
  for (const char* part : {"points share        50.0 %", "2 swapped pairs, 4 matches",
                           "  verdict             no significant difference (95 %)\n"}) {
    INFO(part);
    CHECK(contains(text.out, part));
  }
}

TEST_CASE("what is wrong with a match is said before it begins", "[cli]") {
  const Sandbox box;
  const auto expect = [&](const std::string& arguments, int code, const std::string& part) {
    box.fails("match " + arguments, code, part);
  };
  expect("chasr chaser", 2, "there is no team 'chasr'. Did you mean 'chaser'?");
  expect("chaser chaser --ruls x", 2, "Did you mean '--rules'?");
  expect("chaser chaser --rules vsss-3v", 2, "Did you mean 'vsss-3v3'?");
  expect("chaser chaser --physics standrad", 2, "Did you mean 'standard'?");
  expect("chaser chaser --robot vss", 2, "Did you mean 'vsss'?");
  expect("chaser chaser --half-seconds -3", 2, "half_seconds");
  expect("chaser chaser --half-seconds nan", 2, "--half-seconds: 'nan' is not a number");
  expect("chaser chaser --half-seconds x", 2, "--half-seconds");
  expect("chaser chaser --latency 61", 2, "latency: 61 is outside 0 ... 60");
  expect("chaser chaser --noise 1", 2, "noise: 1 is outside");
  expect("chaser chaser --dropout 1", 2, "dropout: 1 is outside");
  expect("chaser chaser -n 0", 2, "1 ... 100000");
  expect("chaser chaser -n x", 2, "--pairs");
  expect("chaser chaser -n 2 --jobs -1", 2, "0 ... 1024");
  expect("chaser chaser -n 2 --record r.fbr", 2, "--record");
  expect("chaser chaser -n 2 --events -", 2, "--events");
  expect("chaser chaser -n 2 --profile", 2, "--profile");
  expect("chaser chaser --json --events -", 2, "--events");
  expect("chaser chaser --seed -1", 2, "--seed: '-1' is not a whole number");
  expect("chaser chaser third", 2, "third");
  expect("chaser chaser --start missing.toml", 5, "missing.toml");
  expect("chaser chaser --record no/such/m.fbr", 5, "no/such/m.fbr");
  expect("chaser chaser --events no/such/e.jsonl", 5, "no/such/e.jsonl");
  box.write("bad.toml",
            "[ball]\nposition = [0.0, 0.0]\n[[robot]]\nteam = \"red\"\nnumber = 0\nposition = [0, 0]\n");
  expect("chaser chaser --start bad.toml", 3, "bad.toml:4");
  box.write("rules.toml", "[rules]\nname = \"x\"\n[periods]\nhalf_seconds = -1.0\n");
  expect("chaser chaser --rules rules.toml", 3, "rules.toml:4");
  CHECK(std::distance(fs::directory_iterator(box.path), {}) == 2);
}

TEST_CASE("a match on another field than its places are written for says so and is played", "[cli]") {
  const Sandbox box;
  const std::string field = box.run("show field vsss-5v5").out;
  box.write("big.toml", field);
  box.write("mine.toml", "[rules]\nname = \"mine\"\nfield = \"big.toml\"\nteam_size = 5\n");
  const Output output = box.run("match chaser chaser --half-seconds 1 --rules mine.toml");
  CHECK(output.code == 0);
  CHECK(contains(output.err, "Start from: fulbito rules show vsss-5v5"));
  const Output check = box.run("rules check mine.toml");
  CHECK(check.code == 0);
  CHECK(contains(check.out, "note: the places (in metres) of the rules 'mine'"));
  CHECK(box.run("rules check vsss-5v5").out.find("note") == std::string::npos);
}

TEST_CASE("a match that is given a field says where that is set", "[cli]") {
  const Sandbox box;
  const Output output = box.run("match chaser chaser --field vsss-5v5");
  CHECK(output.code == 2);
  CHECK(contains(output.err, "The field belongs to the rules: set rules.field"));
}

TEST_CASE("drills and series show how far they are, with --json too", "[cli]") {
  if (std::system("command -v script >/dev/null 2>&1") != 0) {
    WARN("skipped: no script (bsdutils), which gives a program a terminal");
    return;
  }
  const Sandbox box;
  const auto shown = [&](const std::string& arguments) {
    // A terminal sees both; the JSON goes elsewhere.
    const std::string command = "cd '" + box.path.string() + "' && script -qec \"'" FULBITO_PROGRAM "' " +
                                arguments + " --json >json.txt\" tty.txt >/dev/null </dev/null";
    REQUIRE(std::system(command.c_str()) == 0);
    CHECK_FALSE(Json::parse(contentOf(box.path / "json.txt"), nullptr, false).is_discarded());
    return contentOf(box.path / "tty.txt");
  };
  CHECK(contains(shown("drill chaser --drill 3 --trials 200"), "drills of chaser ["));
  CHECK(shown("match chaser chaser -n 10 --half-seconds 20").find("chaser against chaser: ") !=
        std::string::npos);
}
