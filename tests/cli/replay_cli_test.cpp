#include <sstream>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

/// A folder with two short recorded matches.
struct Recordings : Sandbox {
  Recordings() {
    REQUIRE(run("match chaser chaser --half-seconds 10 --record a.fbr --events a.jsonl").code == 0);
    REQUIRE(run("match chaser chaser --half-seconds 10 --seed 2 --record b.fbr").code == 0);
  }
  void damage(const std::string& file, const std::string& as) const {
    std::string bytes = contentOf(path / file);
    bytes[bytes.size() / 2] ^= 4;
    write(as, bytes);
  }
};

}  // namespace

TEST_CASE("replay info says what was played and where the bytes go", "[cli]") {
  const Recordings box;
  const Output text = box.run("replay info a.fbr");
  CHECK(text.code == 0);
  for (const char* part :
       {"match, level full, format 2, finished", "chaser (blue)", "rules vsss-3v3", "commands"}) {
    INFO(part);
    CHECK(contains(text.out, part));
  }
  const Json json = Json::parse(box.run("replay info a.fbr --json").out);
  CHECK(json["schema_version"] == 1);
  CHECK(json["end"] == "finished");
  CHECK(json["recipe"]["seed"] == 1);
  CHECK(json["simulated_s"].get<double>() >= 20.0);
  std::size_t sum = 0;
  for (const Json& part : json["bytes_by_part"]) sum += part.get<std::size_t>();
  CHECK(sum == json["bytes"].get<std::size_t>());
  CHECK(sum == fs::file_size(box.path / "a.fbr"));
}

TEST_CASE("a recipe is smaller, verifies, and can be shown as well", "[cli]") {
  const Recordings box;
  box.works("match chaser chaser --half-seconds 10 --record r.fbr --recipe");
  CHECK(fs::file_size(box.path / "r.fbr") < fs::file_size(box.path / "a.fbr"));
  CHECK(contains(box.run("replay info r.fbr").out, "level recipe"));
  CHECK(box.run("replay verify r.fbr").code == 0);
  box.works("replay export r.fbr --csv r.csv");
  box.works("replay export a.fbr --csv a.csv");
  CHECK(contentOf(box.path / "r.csv") == contentOf(box.path / "a.csv"));
  CHECK(box.run("match chaser chaser --recipe").code == 2);
}

TEST_CASE("drawings are recorded on request, and change nothing that is played", "[cli]") {
  const Recordings box;
  box.works("match chaser classic --half-seconds 5 --record plain.fbr");
  box.works("match chaser classic --half-seconds 5 --record drawn.fbr --drawings");
  const Json plain = Json::parse(box.run("replay info plain.fbr --json").out);
  const Json drawn = Json::parse(box.run("replay info drawn.fbr --json").out);
  CHECK(plain["drawings"] == 0);
  CHECK(drawn["drawings"].get<int>() > 600);
  CHECK(drawn["result"] == plain["result"]);
  CHECK(box.run("replay verify drawn.fbr").code == 0);
  box.works("replay export drawn.fbr --png with.png --at 3.1");
  box.works("replay export drawn.fbr --png without.png --at 3.1 --no-drawings");
  CHECK(contentOf(box.path / "with.png") != contentOf(box.path / "without.png"));
  CHECK(box.run("match chaser classic --drawings").code == 2);
  CHECK(box.run("match chaser classic --record x.fbr --recipe --drawings").code == 2);
  box.works("run --navigator bezier --record way.fbr --drawings");
  CHECK(Json::parse(box.run("replay info way.fbr --json").out)["drawings"].get<int>() > 10);
  CHECK(box.run("replay verify way.fbr").code == 0);
}

TEST_CASE("recordings are not made in folders that are not there", "[cli]") {
  const Recordings box;
  for (const char* made : {"match chaser idle --half-seconds 1 --record no/x.fbr", "run --record no/x.fbr",
                           "run --png no/x.png", "replay cut a.fbr no/x.fbr --plays 1",
                           "replay export a.fbr --png no/x.png", "replay export a.fbr --jsonl no/x.jsonl"}) {
    INFO(made);
    box.fails(made, 5, "there is no folder 'no'");
  }
  CHECK_FALSE(fs::exists(box.path / "no"));
  fs::create_directory(box.path / "folder");
  CHECK(box.run("replay export a.fbr --png folder --force").err.find("'folder': it is a folder") !=
        std::string::npos);
  CHECK(box.run("replay cut a.fbr - --plays 1").code == 2);
  CHECK(box.run("match chaser idle --half-seconds 1 --record -").code == 2);
  CHECK_FALSE(fs::exists(box.path / "-"));
}

TEST_CASE("replay events gives the lines that the match wrote", "[cli]") {
  const Recordings box;
  CHECK(box.run("replay events a.fbr --json").out == contentOf(box.path / "a.jsonl"));
  const Output text = box.run("replay events a.fbr");
  CHECK(text.code == 0);
  CHECK(contains(text.out, "- kick-off"));
}

TEST_CASE("replay events tells of a recording that does not reach the end", "[cli]") {
  const Recordings box;
  const std::string bytes = contentOf(box.path / "a.fbr");
  box.write("cut.fbr", bytes.substr(0, bytes.size() - 100));
  CHECK_FALSE(contains(box.run("replay events a.fbr").out, "cut off"));
  const Output cut = box.run("replay events cut.fbr");
  CHECK(cut.code == 0);
  CHECK(cut.out.ends_with(" the recording is cut off\n"));
  REQUIRE(box.run("replay cut a.fbr part.fbr --plays 1").code == 0);
  CHECK(box.run("replay events part.fbr").out.ends_with(" the recording ends before the match\n"));
}

TEST_CASE("replay events prints a table with a head, in which a kick-off stands once", "[cli]") {
  const Recordings box;
  const std::string text = box.run("replay events a.fbr").out;
  CHECK(text.starts_with("   time  period      clock  score   call, - restart"));
  CHECK(text.substr(0, text.find('\n')).ends_with("measured"));
  std::istringstream lines(text);
  int restarts = 0;
  for (std::string line; std::getline(lines, line);) {
    CHECK(line.find(" kick-off  ") == line.find("- kick-off  ") + (contains(line, "- kick-off  ")));
    restarts += contains(line, "- kick-off") ? 1 : 0;
  }
  CHECK(restarts >= 2);
}

TEST_CASE("replay verify: the same, different, damaged and cut have their exit codes", "[cli]") {
  const Recordings box;
  const Output good = box.run("replay verify a.fbr");
  CHECK(good.code == 0);
  CHECK(good.out.find("a.fbr: identical, bit for bit: ") == 0);
  const Output folder = box.run("replay verify .");
  CHECK(folder.code == 0);
  CHECK(contains(folder.out, "2 recordings: 2 same, 0 different, 0 cut, 0 bad"));
  CHECK(box.run("replay verify missing.fbr").code == 5);
  const std::string bytes = contentOf(box.path / "b.fbr");
  box.write("cut.fbr", bytes.substr(0, bytes.size() - 100));
  CHECK(box.run("replay verify cut.fbr").code == 3);
  box.damage("b.fbr", "damaged.fbr");
  box.fails("replay verify damaged.fbr", 3, "damaged.fbr: damaged at byte ");
  const Output all = box.run("replay verify . --jobs 2 --json");
  CHECK(all.code == 3);
  const Json json = Json::parse(all.out);
  CHECK(json["same"] == 2);
  CHECK(json["cut"] == 1);
  CHECK(json["bad"] == 1);
  CHECK(json["files"].size() == 4);
}

TEST_CASE("replay diff names what differs", "[cli]") {
  const Recordings box;
  const Output same = box.run("replay diff a.fbr a.fbr");
  CHECK(same.code == 0);
  CHECK(contains(same.out, "are identical, bit for bit"));
  const Output other = box.run("replay diff a.fbr b.fbr");
  CHECK(other.code == 1);
  CHECK(contains(other.out, "seed: 1 in A, 2 in B"));
  CHECK(contains(other.out, "first difference at tick 0"));
  const Json json = Json::parse(box.run("replay diff a.fbr b.fbr --json").out);
  CHECK(json["same"] == false);
  CHECK(json["recipe"][0]["name"] == "seed");
  CHECK(json["bodies"].size() > 3);
}

TEST_CASE("replay cut makes a recording that verifies, and replaces none unasked", "[cli]") {
  const Recordings box;
  CHECK(box.run("replay cut a.fbr c.fbr --plays 2").code == 0);
  CHECK(box.run("replay verify c.fbr").code == 0);
  CHECK(box.run("replay cut a.fbr c.fbr --from 1 --to 2").code == 2);
  CHECK(box.run("replay cut a.fbr c.fbr --from 1 --to 2 --force").code == 0);
  const Json cut = Json::parse(box.run("replay cut a.fbr c.fbr --from 1 --to 2 --force --json").out);
  CHECK(cut["schema_version"] == 1);
  CHECK(cut["out"] == "c.fbr");
  CHECK(cut["first_play"] == 1);
  CHECK(cut["bytes"] == fs::file_size(box.path / "c.fbr"));
  const Json info = Json::parse(box.run("replay info c.fbr --json").out);
  CHECK(info["recipe"]["more"]["cut_plays"].get<std::string>().find("1-") == 0);
  const auto refuses = [&](const std::string& arguments, const std::string& part) {
    box.fails("replay cut a.fbr d.fbr " + arguments, 2, part);
  };
  refuses("", "--plays A-B, or --from and --to");
  refuses("--plays 1 --from 2", "--plays A-B, or --from and --to");
  refuses("--plays 5-2", "'5-2' is not a range");
  refuses("--plays 0", "'0' is not a range");
  refuses("--plays x", "'x' is not a range");
  refuses("--plays 1-999", "are not within 1 ... ");
  refuses("--from 2 --to 1", "--from 2 is after --to 1");
  refuses("--from 500 --to 600", "no play overlaps 500 ... 600 s");
  CHECK_FALSE(fs::exists(box.path / "d.fbr"));
}

TEST_CASE("replay repair keeps what can be read and says what was lost", "[cli]") {
  const Recordings box;
  const Output whole = box.run("replay repair a.fbr mended.fbr");
  CHECK(whole.code == 0);
  CHECK(contains(whole.out, "not damaged"));
  box.damage("a.fbr", "damaged.fbr");
  const Output mended = box.run("replay repair damaged.fbr mended.fbr");
  CHECK(mended.code == 0);
  CHECK(contains(mended.out, "lost: "));
  CHECK(box.run("replay verify mended.fbr").code == 0);
  CHECK(box.run("replay repair damaged.fbr mended.fbr").code == 2);
  const Json lost = Json::parse(box.run("replay repair damaged.fbr mended.fbr --force --json").out);
  CHECK(lost["schema_version"] == 1);
  CHECK(lost["whole"] == false);
  CHECK(lost["bytes"] == fs::file_size(box.path / "mended.fbr"));
  CHECK(lost["lost"]["bytes"].get<int>() > 0);
  const Json none = Json::parse(box.run("replay repair a.fbr unneeded.fbr --json").out);
  CHECK(none["whole"] == true);
  CHECK(none["out"].is_null());
  CHECK_FALSE(fs::exists(box.path / "unneeded.fbr"));
  box.write("nothing.fbr", "not a recording");
  CHECK(box.run("replay repair nothing.fbr x.fbr").code == 3);
}

TEST_CASE("a part of replay that does not exist is named with a suggestion", "[cli]") {
  const Sandbox box;
  box.fails("replay verfy x.fbr", 2, "there is no subcommand 'verfy'. Did you mean 'verify'?");
  CHECK(box.run("replay").code == 2);
  CHECK(contains(box.run("replay verify x.fbr --jbs 2").err, "Did you mean '--jobs'?"));
}

TEST_CASE("trials record and verify", "[cli]") {
  const Sandbox box;
  box.works("run --layout corner:3 --navigator bezier --record way.fbr");
  CHECK(box.run("replay verify way.fbr").code == 0);
  const Json info = Json::parse(box.run("replay info way.fbr --json").out);
  CHECK(info["kind"] == "trial");
  CHECK(info["recipe"]["navigator"] == "bezier");
  CHECK(info["result"]["figures"].contains("time_s"));
  box.works(
      "compare --suite moving --navigators bezier straight --speeds 1.0 --trials 4 --pictures 2 "
      "--record ways --out out");
  CHECK(std::distance(fs::directory_iterator(box.path / "ways"), {}) == 4);
  const Output verified = box.run("replay verify ways");
  CHECK(verified.code == 0);
  CHECK(contains(verified.out, "4 recordings: 4 same"));
}
