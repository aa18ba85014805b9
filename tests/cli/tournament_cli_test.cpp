#include <regex>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

constexpr const char* kFiles =
    " --html report.html --csv matches.csv --markdown summary.txt --junit report.xml";

std::size_t linesOf(const fs::path& file) {
  const std::string text = contentOf(file);
  return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

/// A plan file of three quick teams.
std::string planOf(const std::string& settings) {
  return "[tournament]\nname = \"three\"\n" + settings +
         "\n[match]\nhalf_seconds = 4\n[[team]]\nteam = \"classic\"\n[[team]]\nteam = \"chaser\"\n"
         "[[team]]\nteam = \"random\"\n";
}

/// What a command printed and all reports that it wrote.
std::string reportsOf(const Sandbox& box, const std::string& arguments) {
  const Output output = box.run(arguments + " --json" + kFiles);
  INFO(arguments << "\n" << output.err);
  CHECK((output.code == 0 || output.code == 6));
  std::string all = output.out;
  for (const char* file : {"report.html", "matches.csv", "summary.txt", "report.xml"}) {
    CHECK(fs::file_size(box.path / file) > 100);
    all += contentOf(box.path / file);
  }
  return all;
}

/// Plays the shards of a plan, the last one first.
std::string playShards(const Sandbox& box, const std::string& plan, int count, const std::string& flags) {
  std::string folders;
  for (int i = count; i >= 1; --i) {
    const std::string folder = "s" + std::to_string(count) + "-" + std::to_string(i);
    const Output output = box.run("tournament run " + plan + " --shard " + std::to_string(i) + "/" +
                                  std::to_string(count) + " --out " + folder + flags);
    INFO(output.err);
    CHECK(output.code == 0);
    folders += " " + folder;
  }
  return folders;
}

/// A team in Python with this body of `decide(self, seen, commands)`.
void writeTeam(const Sandbox& box, const std::string& name, const std::string& body) {
  box.works("new-team python " + name);
  box.write(name + "/team.py",
            "import os, random\nfrom fulbito_team import Commands, Observation, Team, run\n\n"
            "class MyTeam(Team):\n    count = 0\n    def decide(self, seen: Observation) -> Commands:\n"
            "        commands = Commands()\n        self.count += 1\n        " +
                body + "\n        return commands\n\nrun(MyTeam())\n");
}

/// A team whose matches never repeat.
void writeVaryingTeam(const Sandbox& box) {
  writeTeam(box, "varying", "commands.twist(1, random.SystemRandom().random(), 0.0)");
}

constexpr const char* kVarying =
    "tournament run 'cmd:python3 varying/team.py' chaser --format match --half-seconds 2";

}  // namespace

TEST_CASE("a tournament reports the same bytes for any jobs and shards", "[cli]") {
  const Sandbox box;
  box.write("plan.toml", planOf("pairs = 3\nstarts = \"kick-off, play\""));
  const std::string whole = reportsOf(box, "tournament run plan.toml --out whole --jobs 1");
  CHECK(reportsOf(box, "tournament run plan.toml --out two --jobs 2") == whole);
  CHECK(reportsOf(box, "tournament run plan.toml --out four --jobs 4") == whole);
  for (const int count : {1, 3, 7}) {
    const std::string folders =
        playShards(box, "plan.toml", count, " --jobs " + std::to_string(count == 7 ? 4 : count));
    CHECK(reportsOf(box, "tournament merge" + folders + " --out m" + std::to_string(count)) == whole);
  }
  CHECK(reportsOf(box, "tournament report m7") == whole);
}

TEST_CASE("a sequential test has the same reports for any jobs and shards", "[cli]") {
  const Sandbox box;
  const std::string plan = "chaser idle --format match --pairs 40 --half-seconds 8 --bounds 0,200";
  const std::string whole = reportsOf(box, "tournament run " + plan + " --out whole --jobs 1");
  CHECK(reportsOf(box, "tournament run " + plan + " --out two --jobs 4") == whole);
  const std::string folders = playShards(box, plan, 3, "");
  CHECK(reportsOf(box, "tournament merge" + folders + " --out merged") == whole);
}

TEST_CASE("rounds that depend on results go on from merged shards", "[cli]") {
  const Sandbox box;
  box.write("plan.toml", planOf("format = \"knock-out\""));
  const std::string whole = reportsOf(box, "tournament run plan.toml --out whole");
  int rounds = 0;
  for (int code = 6; code == 6 && rounds < 9; ++rounds) {
    const std::string folders = playShards(box, "plan.toml", 2, "");
    code = box.run("tournament merge" + folders + " --out merged").code;
    for (const char* shard : {"s2-1", "s2-2"}) {
      CHECK((box.run("tournament merge merged --out " + std::string(shard)).code == code));
    }
  }
  CHECK(rounds > 1);
  CHECK(reportsOf(box, "tournament report merged") == whole);
}

TEST_CASE("a run that was killed continues where it was", "[cli]") {
  const Sandbox box;
  box.write("plan.toml", planOf("pairs = 8"));
  const Output killed = box.shell(
      "\"$F\" tournament run plan.toml --out o --jobs 1 2>/dev/null & pid=$!\n"
      "until [ \"$(wc -l <o/matches.jsonl 2>/dev/null || echo 0)\" -gt 3 ]; do :; done\n"
      "kill -9 $pid; wait $pid 2>/dev/null; wc -l <o/matches.jsonl");
  const int before = std::stoi(killed.out) - 1;
  REQUIRE(before < 48);
  const Output continued = box.run("tournament run plan.toml --out o");
  CHECK(continued.code == 0);
  CHECK(contains(continued.err, std::to_string(48 - before) + " matches played, " + std::to_string(before)));
  CHECK(linesOf(box.path / "o/matches.jsonl") == 49);
  CHECK(reportsOf(box, "tournament report o") == reportsOf(box, "tournament run plan.toml --out whole"));
}

TEST_CASE("a signal keeps the results of a tournament", "[cli]") {
  const Sandbox box;
  box.write("plan.toml", planOf("pairs = 50"));
  const Output stopped = box.shell(
      "\"$F\" tournament run plan.toml --out o --jobs 1 & pid=$!\n"
      "until [ \"$(wc -l <o/matches.jsonl 2>/dev/null || echo 0)\" -gt 3 ]; do :; done\n"
      "kill -TERM $pid; wait $pid");
  CHECK(stopped.code == 143);
  CHECK(contains(stopped.err, "stopped; the same command continues"));
  CHECK(linesOf(box.path / "o/matches.jsonl") > 3);
}

TEST_CASE("a report tells of a tournament that runs", "[cli]") {
  const Sandbox box;
  box.write("plan.toml", planOf("pairs = 50"));
  const Output during = box.shell(
      "\"$F\" tournament run plan.toml --out o --jobs 1 >/dev/null 2>&1 & pid=$!\n"
      "until [ \"$(wc -l <o/matches.jsonl 2>/dev/null || echo 0)\" -gt 3 ]; do :; done\n"
      "\"$F\" tournament report o --json; code=$?\n"
      "\"$F\" tournament run plan.toml --out o >/dev/null 2>second; echo $? >>second\n"
      "kill $pid; wait $pid; exit $code");
  CHECK(during.code == 0);
  const Json json = Json::parse(during.out);
  CHECK(json["finished"] == false);
  CHECK(json["pairs_counted"] < 150);
  CHECK(contains(contentOf(box.path / "second"), "\n2\n"));
}

TEST_CASE("a folder refuses another plan and says what differs", "[cli]") {
  const Sandbox box;
  box.write("plan.toml", planOf("pairs = 1"));
  box.works("tournament run plan.toml --out o");
  const std::string log = contentOf(box.path / "o/matches.jsonl");
  const Output other = box.run("tournament run plan.toml --out o --pairs 2 --half-seconds 5");
  CHECK(other.code == 2);
  CHECK(contains(other.err, "pairs: 1 -> 2"));
  CHECK(contains(other.err, "half_seconds"));
  box.works("tournament run classic idle --half-seconds 4 --out p");
  const Output merged = box.run("tournament merge o p --out q");
  CHECK(merged.code == 2);
  CHECK_FALSE(fs::exists(box.path / "q"));
  CHECK(contentOf(box.path / "o/matches.jsonl") == log);
}

TEST_CASE("merging tells missing shards and runs that differ by the exit code", "[cli]") {
  const Sandbox box;
  box.write("plan.toml", planOf("pairs = 1"));
  playShards(box, "plan.toml", 3, "");
  box.ends("tournament merge s3-1 s3-3 --out m", 6, "matches are missing");
  CHECK(box.run("tournament merge s3-2 --out m").code == 0);

  writeVaryingTeam(box);
  box.works(std::string(kVarying) + " --out a");
  box.works(std::string(kVarying) + " --out b");
  box.fails("tournament merge a b --out c --html c.html", 7, "two runs of one match differ");
  CHECK_FALSE(fs::exists(box.path / "c"));
  CHECK_FALSE(fs::exists(box.path / "c.html"));
}

TEST_CASE("the flag --verify plays matches again, and 7 tells that they differ", "[cli]") {
  const Sandbox box;
  const Output same = box.run("tournament run chaser random --half-seconds 3 --out same --verify 100%");
  CHECK(same.code == 0);
  CHECK(contains(same.err, "2 matches played twice, 0 of them differ"));
  writeVaryingTeam(box);
  box.ends(std::string(kVarying) + " --out o --verify 100%", 7, "differs: ");
}

TEST_CASE("a cache saves matches between tournaments, but not those that vary", "[cli]") {
  const Sandbox box;
  const std::string run = "tournament run classic chaser random --half-seconds 3 --cache c";
  CHECK(contains(box.run(run + " --out a").err, "6 matches played, 0 were there"));
  CHECK(contains(box.run(run + " --out b").err, "0 matches played, 6 were there"));
  CHECK(contains(box.run("tournament run chaser random idle --half-seconds 3 --cache c --out f").err,
                 "4 matches played, 2 were there"));
  CHECK(reportsOf(box, "tournament report a") == reportsOf(box, "tournament report b"));
  writeVaryingTeam(box);
  const Output varying = box.run(std::string(kVarying) + " --cache d --out e");
  CHECK(contains(varying.err, "does not repeat its decisions"));
  CHECK(contains(varying.err, "2 matches played"));
  CHECK(fs::is_empty(box.path / "d"));
}

TEST_CASE("the flag --strict fails a run in which a team crashed", "[cli]") {
  const Sandbox box;
  writeTeam(box, "crashing", "if self.count > 30: os._exit(1)");
  const std::string run =
      "tournament run 'cmd:python3 crashing/team.py' chaser --format match --half-seconds 2 ";
  CHECK(box.run(run + "--out o").code == 0);
  CHECK(box.run(run + "--out o --strict").code == 4);
  const Output annotated = box.run("tournament report o --annotations");
  CHECK(contains(annotated.out, "::"));
  CHECK(contains(contentOf(box.path / "o/matches.jsonl"), "\"outcome\":\"forfeit\""));
}

TEST_CASE("the flag --dry-run prints the schedule and plays nothing", "[cli]") {
  const Sandbox box;
  const Output output = box.run("tournament run classic chaser random --pairs 2 --out o --dry-run");
  CHECK(output.code == 0);
  CHECK(contains(output.out, "3 entrants, 12 matches"));
  CHECK_FALSE(fs::exists(box.path / "o"));
}

TEST_CASE("recordings are kept by policy, and the report links pages that exist", "[cli]") {
  const Sandbox box;
  const auto recordings = [&](const std::string& folder) {
    std::vector<fs::path> files;
    if (!fs::exists(box.path / folder / "recordings")) return files;
    for (const auto& file : fs::directory_iterator(box.path / folder / "recordings")) files.push_back(file);
    return files;
  };
  const std::string run = "tournament run classic chaser idle --half-seconds 8 ";
  const Output without = box.run(run + "--out none --html none.html");
  REQUIRE(without.code == 0);
  CHECK(recordings("none").empty());
  box.works(run + "--out all --recordings all --html all.html");
  CHECK(recordings("all").size() == 6);
  box.works(run + "--out some --recordings upsets --html some.html");
  const auto some = recordings("some");
  CHECK(!some.empty());
  CHECK(some.size() < 6);
  for (const fs::path& file : some) {
    CHECK(box.run("replay verify " + file.string()).code == 0);
    CHECK(contentOf(file) == contentOf(box.path / "all/recordings" / file.filename()));
  }

  const std::string page = contentOf(box.path / "some.html");
  const std::regex link("href=\"\\./(some-matches/[0-9a-f]{32}\\.html)\"");
  std::size_t links = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), link), end; it != end; ++it, ++links) {
    const std::string viewer = contentOf(box.path / (*it)[1].str());
    CHECK(contains(viewer, "<canvas"));
    CHECK(contains(viewer, "</html>"));
  }
  CHECK(links == some.size());
  CHECK_FALSE(contains(contentOf(box.path / "none.html"), "none-matches"));
  CHECK(contains(contentOf(box.path / "none.html"), "To watch them: fulbito tournament report"));
  CHECK_FALSE(contains(page, "To watch them"));

  // The command that the run has named records them now.
  const std::string named = "tournament report none --recordings upsets --html none.html";
  CHECK(contains(without.err, "to watch the matches to look at: fulbito " + named + "\n"));
  box.works(named);
  CHECK(recordings("none").size() == some.size());
  for (const fs::path& file : some) {
    CHECK(contentOf(file) == contentOf(box.path / "none/recordings" / file.filename()));
  }
  const std::string later = contentOf(box.path / "none.html");
  CHECK(contains(later, "none-matches"));
  CHECK_FALSE(contains(later, "To watch them"));
}

TEST_CASE("reports may go into the folder of the results", "[cli]") {
  const Sandbox box;
  const std::string run = "tournament run chaser random --half-seconds 2 --out ";
  CHECK(box.run(run + "o --html o/report.html --csv ./o/matches.csv").code == 0);
  CHECK(fs::file_size(box.path / "o/report.html") > 100);
  CHECK(fs::file_size(box.path / "o/matches.csv") > 100);
  CHECK(box.run("tournament merge o --out m/ --html m/report.html").code == 0);
  CHECK(fs::exists(box.path / "m/report.html"));
  CHECK(box.run("sprt chaser random --half-seconds 2 --pairs 1 --out s --markdown s/summary.txt").code == 6);
  CHECK(fs::exists(box.path / "s/summary.txt"));
  CHECK(box.run(run + "p --html q/report.html").code == 5);
  CHECK_FALSE(fs::exists(box.path / "p"));
}

TEST_CASE("upsets of merged shards are recorded afterwards", "[cli]") {
  const Sandbox box;
  box.write("plan.toml", planOf("pairs = 2"));
  const std::string flags = " --recordings upsets --html report.html --out ";
  box.works("tournament run plan.toml" + flags + "whole");
  const std::string whole = contentOf(box.path / "report.html");
  const std::string folders = playShards(box, "plan.toml", 2, "");
  box.works("tournament merge" + folders + " --out merged");
  const Output recorded = box.run("tournament run plan.toml" + flags + "merged");
  CHECK(contains(recorded.err, "0 matches played, 12 were there"));
  CHECK(contains(whole, "report-matches/"));
  CHECK(contentOf(box.path / "report.html") == whole);
}

TEST_CASE("the flag --shard auto reads the variables of Slurm and Kubernetes", "[cli]") {
  const Sandbox box;
  const auto shard = [&](const std::string& variables, const std::string& flag) {
    fs::remove_all(box.path / "o");
    return box.shell(variables +
                     " \"$F\" tournament run chaser random --half-seconds 2 --pairs 3 --out o --shard " +
                     flag);
  };
  const std::string slurm =
      "SLURM_ARRAY_TASK_MIN=10 SLURM_ARRAY_TASK_MAX=20 SLURM_ARRAY_TASK_COUNT=3 SLURM_ARRAY_TASK_ID=15";
  CHECK(contains(shard(slurm, "auto").err, "shard 2 of 3"));
  CHECK(contains(shard(slurm, "auto/3").err, "shard 2 of 3"));
  CHECK(shard(slurm, "auto/4").code == 2);
  CHECK(contains(shard("JOB_COMPLETION_INDEX=2", "auto/3").err, "shard 3 of 3"));
  CHECK(shard("JOB_COMPLETION_INDEX=3", "auto/3").code == 2);
  CHECK(contains(shard("JOB_COMPLETION_INDEX=2", "auto").err, "auto/N"));
  CHECK(shard("", "auto").code == 2);
}

TEST_CASE("tournament refuses what makes no sense and says why", "[cli]") {
  const Sandbox box;
  box.write("key.toml", planOf("paris = 2"));
  box.write("value.toml", planOf("pairs = 0"));
  box.write("team.toml", planOf("") + "[[team]]\nteam = \"clasic\"\n");
  box.write("twice.toml", planOf("") + "[[team]]\nteam = \"classic\"\n");
  const auto refused = [&](const std::string& arguments, int code, const std::string& text) {
    box.fails("tournament " + arguments, code, text);
  };
  refused("run key.toml", 3, "key.toml:3");
  refused("run value.toml", 3, "pairs");
  refused("run team.toml", 2, "classic");
  refused("run twice.toml", 2, "classic");
  refused("run none.toml", 5, "none.toml");
  refused("run classic", 2, "");
  refused("run classic nobody", 2, "nobody");
  for (const char* flag :
       {"--format cup", "--pairs 0", "--shard 4/3", "--shard 0/3", "--shard 1", "--verify 101%", "--verify x",
        "--recordings some", "--starts corner", "--groups 9"}) {
    const std::string name = std::string(flag).substr(2, std::string(flag).find(' ') - 2);
    refused(std::string("run classic chaser ") + flag, 2, name);
  }
  refused("run classic chaser --json --csv -", 2, "stdout");
  refused("report nowhere", 5, "nowhere");
  refused("merge nowhere --out o", 5, "nowhere");
  refused("", 2, "");
  CHECK_FALSE(fs::exists(box.path / "fulbito-tournament"));
}

TEST_CASE("matches that end by forfeit have recordings that verify, and pages", "[cli]") {
  const Sandbox box;
  writeTeam(box, "quits", "if self.count > 9: os._exit(3)");
  const Output played = box.run(
      "tournament run 'cmd:python3 quits/team.py' idle --pairs 1 --half-seconds 1 --recordings all --out o "
      "--html r.html");
  INFO(played.err);
  REQUIRE(played.code == 0);
  CHECK(contains(played.out, "forfeit"));
  std::size_t pages = 0;
  for (const auto& recording : fs::directory_iterator(box.path / "o/recordings")) {
    ++pages;
    const std::string page = "r-matches/" + recording.path().stem().string() + ".html";
    CHECK(contains(contentOf(box.path / page), "\"score\":["));
  }
  CHECK(pages == 2);
  CHECK(box.run("replay verify o/recordings").code == 0);
}
