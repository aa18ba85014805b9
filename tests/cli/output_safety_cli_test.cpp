#include <algorithm>
#include <map>
#include <regex>
#include <sstream>
#include <sys/stat.h>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

/// A command line with all that a command needs, and the files of its own that no output may take.
struct Line {
  std::string command;
  std::string words;
  std::vector<std::string> files;
};

const std::vector<std::string> kResults{"results/plan.json", "results/matches.jsonl", "tuning/tune.json",
                                        "tuning/matches.jsonl"};

std::vector<Line> lines() {
  std::vector<Line> all{
      {"match",
       "idle 'cmd:python3 team/team.py' --half-seconds 1 --rules rules.toml --start start.toml",
       {"rules.toml", "start.toml", "team/team.py", "team/team.toml"}},
      {"serve",
       "--blue idle --rules rules.toml --start start.toml --interface 127.0.0.1 --wait 0.1",
       {"rules.toml", "start.toml"}},
      {"client", "idle --rules rules.toml --host nowhere", {"rules.toml"}},
      {"record",
       "new.fbr --rules rules.toml --robot robot.toml --interface 127.0.0.1 --wait 0.1",
       {"rules.toml", "robot.toml"}},
      {"run", "--layout layout.toml --robot robot.toml", {"layout.toml", "robot.toml"}},
      {"compare",
       "--suite corner --trials 1 --navigators straight --speeds 1 --pictures 0 --robot robot.toml "
       "--out products",
       {"robot.toml"}},
      {"check-team", "'cmd:python3 team/team.py' --quick", {"team/team.py", "team/team.toml"}},
      {"new-team", "python own", {}},
      {"drill", "idle --drill 1 --trials 1 --robot robot.toml", {"robot.toml"}},
      {"view", "a.fbr", {"a.fbr"}},
      {"rules show", "rules.toml", {"rules.toml"}},
      {"rules check", "rules.toml", {"rules.toml"}},
      {"rules compare", "training rules.toml a.fbr", {"rules.toml", "a.fbr"}},
      {"replay info", "a.fbr", {"a.fbr"}},
      {"replay events", "a.fbr", {"a.fbr"}},
      {"replay verify", "a.fbr", {"a.fbr"}},
      {"replay diff", "a.fbr b.fbr", {"a.fbr", "b.fbr"}},
      {"replay cut", "a.fbr", {"a.fbr"}},
      {"replay send", "a.fbr --interface 127.0.0.1 --speed 20 --from 1", {"a.fbr"}},
      {"replay repair", "cut.fbr", {"cut.fbr"}},
      {"replay export", "a.fbr --html - --ghost b.fbr", {"a.fbr", "b.fbr"}},
      {"sprt", "idle idle -n 1 --half-seconds 1 --rules rules.toml --cache cache", {"rules.toml"}},
      {"tune",
       "classic --iterations 1 -n 1 --final-pairs 0 --half-seconds 1 --out tuning --seed 3",
       {"tuning/tune.json"}},
      {"tournament run", "plan.toml --out results", {"plan.toml", "rules.toml", "start.toml"}},
      {"tournament report", "results", {}},
      {"tournament merge", "results --out merged", {}},
      {"tournament navigators", "straight bezier --suite corner -n 1 --robot robot.toml", {"robot.toml"}},
      {"list", "teams", {}},
      {"show", "robot vsss", {}},
      {"bench", "--signature", {}},
      {"version", "", {}},
  };
  if (FULBITO_EXPERIMENTS) all.push_back({"experiment", "list", {}});
  return all;
}

/// The files that the lines need. Teams do not start: the checks come first.
struct Workshop : Sandbox {
  Workshop() {
    write("rules.toml", run("rules show training").out);
    write("robot.toml", run("show robot vsss").out);
    write("layout.toml", run("show case fig1-abrupt-turns").out);
    write("start.toml",
          "[ball]\nposition = [0.1, 0.2]\n[[robot]]\nteam = 'blue'\nnumber = 0\nposition = [-0.3, 0.0]\n"
          "[[robot]]\nteam = 'yellow'\nnumber = 0\nposition = [0.3, 0.0]\n");
    fs::create_directory(path / "team");
    write("team/team.py", "print('a team')\n");
    write("team/team.toml", "version = \"1\"\n");
    write("plan.toml",
          "[tournament]\nformat = 'match'\npairs = 1\n[match]\nhalf_seconds = 1\nrules = \"rules.toml\"\n"
          "start = \"./start.toml\"\n[[team]]\nteam = 'idle'\n[[team]]\nteam = 'idle'\nname = 'two'\n");
    REQUIRE(run("match idle idle --half-seconds 1 --record a.fbr").code == 0);
    REQUIRE(run("match idle chaser --half-seconds 1 --record b.fbr").code == 0);
    write("cut.fbr", contentOf(path / "b.fbr").substr(0, 3000));
    const Output played = run("tournament run plan.toml --out results");
    INFO(played.err);
    REQUIRE(played.code == 0);
    REQUIRE(
        run("tune classic --iterations 1 -n 1 --final-pairs 0 --half-seconds 1 --out tuning --seed 3").code ==
        0);
  }
};

/// Another name of a file: by its folder, a link, a hard link, the whole path.
std::string aliasOf(const Sandbox& box, const std::string& file, std::size_t kind) {
  fs::remove(box.path / "alias");
  switch (kind % 4) {
    case 0:
      return "./team/../" + file;
    case 1:
      fs::create_symlink(box.path / file, box.path / "alias");
      return "alias";
    case 2:
      fs::create_hard_link(box.path / file, box.path / "alias");
      return "alias";
    default:
      return (box.path / file).string();
  }
}

bool isNumber(const std::string& type) {
  for (const char* number : {"UINT", "INT", "FLOAT", "S", "N", "PERCENT", "PAIRS", "NUMBER"}) {
    if (type == number || type.starts_with(std::string(number) + "=")) return true;
  }
  return false;
}

/// The options of a command with a value that is no number, and how the help shows the value. An argument
/// that names an output has no name here.
std::map<std::string, std::string> textOptions(const std::string& help) {
  std::map<std::string, std::string> options;
  std::istringstream rows(help);
  for (std::string row; std::getline(rows, row);) {
    if (row.starts_with("  out TEXT")) options[""] = "TEXT";
    const std::size_t begin = row.find("--"), end = row.find(' ', begin);
    if (!row.starts_with("  -") || end == std::string::npos || row[end + 1] == ' ') continue;
    const std::string type = row.substr(end + 1, row.find("  ", end) - end - 1);
    if (!isNumber(type)) options[row.substr(begin, end - begin)] = type;
  }
  return options;
}

/// The commands of the help, with those of groups: "replay cut".
void collectCommands(const Sandbox& box, const std::string& group, std::vector<std::string>& all) {
  const std::string help = box.run(group + " --help").out;
  const std::size_t list = help.find("Subcommands:\n");
  if (list == std::string::npos) {
    all.push_back(group);
    return;
  }
  std::istringstream rows(help.substr(list + 13));
  for (std::string row; std::getline(rows, row) && row.starts_with("  ");) {
    const std::string name = row.substr(2, row.find(' ', 2) - 2);
    if (!name.empty()) collectCommands(box, group + (group.empty() ? "" : " ") + name, all);
  }
}

/// One for all tests, which leave its files as they are.
const Workshop& workshop() {
  static const Workshop shared;
  return shared;
}

}  // namespace

TEST_CASE("the test of outputs knows every command of the help", "[cli]") {
  const Sandbox box;
  std::vector<std::string> commands, known;
  collectCommands(box, "", commands);
  for (const Line& line : lines()) known.push_back(line.command);
  std::sort(commands.begin(), commands.end());
  std::sort(known.begin(), known.end());
  CHECK(commands == known);
}

TEST_CASE("no option of any command replaces an input of it or a file that keeps results", "[cli]") {
  const Workshop& box = workshop();
  std::size_t tried = 0, refused = 0;
  for (const Line& line : lines()) {
    const std::string help = box.run(line.command + " --help").out;
    const std::string force = contains(help, " --force ") ? " --force" : "";
    for (const auto& [option, type] : textOptions(help)) {
      if (!option.empty() && contains(line.words, option + " ")) continue;
      std::vector<std::string> victims = line.files;
      victims.push_back(kResults[tried % kResults.size()]);
      const bool file = contains(type, "FILE") || contains(type, "OUT");
      // What is no file by its help gets one name, in turn.
      if (!file && !option.empty()) victims = {victims[tried % victims.size()]};
      for (const std::string& victim : victims) {
        const std::string before = contentOf(box.path / victim);
        REQUIRE_FALSE(before.empty());
        const std::string name = tried % 2 == 0 ? victim : aliasOf(box, victim, tried / 2);
        const std::string value = (contains(type, "WHO") ? "ball " : "") + name;
        const std::string words = line.command + " " + line.words + " " + option + " " + value + force;
        const Output output = box.run(words);
        INFO(words << "\n" << output.err);
        CHECK(contentOf(box.path / victim) == before);
        CHECK(output.code != 70);
        ++tried;
        refused += output.code == 2 ? 1 : 0;
      }
    }
  }
  INFO(tried << " tried, " << refused << " refused");
  CHECK(tried > 130);
  CHECK(refused > 100);
}

TEST_CASE("what a server sends replaces no input and no file of another kind", "[cli]") {
  const Workshop& box = workshop();
  for (const char* victim : {"rules.toml", "results/plan.json", "start.toml"}) {
    const std::string before = contentOf(box.path / victim);
    box.fails(std::string("record ") + victim + " --rules rules.toml --wait 0.1", 2, victim);
    CHECK(contentOf(box.path / victim) == before);
  }
  box.fails("record rules.toml --rules rules.toml --wait 0.1 --force", 2, "rules.toml");
  CHECK_FALSE(contentOf(box.path / "rules.toml").empty());
}

TEST_CASE("names that a folder of results needs are not free, though nothing has them yet", "[cli]") {
  const Workshop& box = workshop();
  for (const std::string name :
       {"fresh/matches.jsonl", "fresh/plan.json", "./fresh//tune.json", "team/../fresh/plan.json"}) {
    for (const std::string flag : {"--csv", "--junit", "--html", "--markdown"}) {
      const Output output = box.run("tournament run plan.toml --out fresh --force " + flag + " " + name);
      INFO(flag << " " << name << "\n" << output.err);
      CHECK(output.code == 2);
      CHECK_FALSE(fs::exists(box.path / "fresh"));
    }
  }
  CHECK(box.run("tune classic --out fresh --png fresh/matches.jsonl").code == 2);
  CHECK(box.run("compare --suite corner --trials 1 --out fresh --html fresh/trials.csv").code == 2);
  CHECK(box.run("tournament run plan.toml --out results --csv results/recordings/x.csv").code == 2);
  CHECK(box.run("tournament run plan.toml --cache cache --out results --csv cache/x.csv").code == 2);
}

TEST_CASE("a report replaces its last one, an empty file, and with --force others, but no input", "[cli]") {
  const Workshop& box = workshop();
  const std::map<std::string, std::string> reports{
      {"--csv", "r.csv"}, {"--html", "r.html"}, {"--junit", "r.xml"}, {"--markdown", "r.txt"}};
  for (const auto& [flag, file] : reports) {
    const std::string command = "tournament report results " + flag + " " + file;
    INFO(command);
    box.write(file, "");
    box.works(command);
    const std::string report = contentOf(box.path / file);
    CHECK(report.size() > 100);
    CHECK(box.run(command).code == 0);
    for (const std::string own : {"# My notes\n", "<!doctype html>\n<html><body>mine</body></html>\n",
                                  "name,age\nme,7\n", "{\n  \"schema_version\": 1\n}\n"}) {
      box.write(file, own);
      box.fails(command, 2, flag + ": '" + file + "' exists and is not ");
      CHECK(contentOf(box.path / file) == own);
      CHECK(box.run(command + " --force").code == 0);
      CHECK(contentOf(box.path / file) == report);
    }
  }
  const std::string draw =
      "tune classic --iterations 1 -n 1 --final-pairs 0 --half-seconds 1 --out tuning --seed 3 --png p.png";
  CHECK(box.run(draw).code == 0);
  CHECK(box.run(draw).code == 0);
  box.write("p.png", "my picture");
  CHECK(box.run(draw).code == 2);
  CHECK(contentOf(box.path / "p.png") == "my picture");
}

TEST_CASE("a folder of products replaces its own files, and no others without --force", "[cli]") {
  const Sandbox box;
  const std::string command =
      "compare --suite corner --trials 1 --navigators straight bezier --speeds 1 --pictures 1 --out out";
  box.works(command);
  box.works(command);
  for (const std::string file : {"trials.csv", "time.png"}) {
    const std::string before = contentOf(box.path / "out" / file);
    REQUIRE_FALSE(before.empty());
    box.write("out/" + file, "somebody's notes\n");
    const Output output = box.run(command);
    INFO(file << ": " << output.err);
    CHECK(output.code == 2);
    CHECK(output.out.empty());  // said before the work
    CHECK(contentOf(box.path / "out" / file) == "somebody's notes\n");
    fs::remove(box.path / "out" / file);
  }
  box.write("out/results.json", "somebody's notes\n");
  CHECK(box.run(command + " --force").code == 0);
  CHECK(contentOf(box.path / "out/results.json").starts_with("{"));
}

TEST_CASE("a name that promises another kind of file is refused, with the option for it", "[cli]") {
  const Workshop& box = workshop();
  for (const auto& [words, advice] :
       {std::pair{"replay export a.fbr --gif film.PNG", "use --png"},
        std::pair{"replay export a.fbr --png still.gif", "use --gif"},
        std::pair{"replay export a.fbr --mp4 film.webm", "use --webm"},
        std::pair{"replay export a.fbr --heatmap ball map.svg", "use --svg"},
        std::pair{"replay export a.fbr --html page.csv", "use --csv"},
        std::pair{"run --png way.fbr", "use --record"},
        std::pair{"match idle idle --half-seconds 1 --record game.png", "use --screenshot"},
        std::pair{"tournament report results --csv table.html", "use --html"},
        std::pair{"tune classic --png path.gif", "choose another name"},
        std::pair{"replay cut a.fbr piece.jsonl", "choose another name"}}) {
    box.fails(words, 2, advice);
  }
  CHECK(box.run("replay export a.fbr --png still.picture").code == 0);
}

TEST_CASE("a long GIF says what it will weigh, before it is written", "[cli]") {
  const Sandbox box;
  box.works("match chaser classic --half-seconds 15 --seed 5 --record a.fbr");
  const Output film = box.run("replay export a.fbr --gif a.gif --size 240 --speed 1");
  REQUIRE(film.code == 0);
  std::smatch said;
  REQUIRE(
      std::regex_search(film.err, said, std::regex("--gif: \\d+ frames, [0-9.]+ s, about ([0-9.]+) MB; ")));
  const double told = std::stod(said[1]), is = static_cast<double>(fs::file_size(box.path / "a.gif")) / 1e6;
  INFO(told << " MB told, " << is << " MB written");
  CHECK(told > 0.5 * is - 0.1);
  CHECK(told < 2.0 * is + 0.1);
  CHECK(contains(film.err, "--from and --to"));
  const Output clip = box.run("replay export a.fbr --gif b.gif --size 240 --from 1 --to 3");
  CHECK(clip.err.find("about") == std::string::npos);
}

TEST_CASE("what has the name of a found file and is none is named, and nothing hangs", "[cli]") {
  const Sandbox box;
  const auto refused = [&](const std::string& words, const std::string& file) { box.fails(words, 5, file); };
  box.works("new-team python own");
  const std::string play = "tournament run 'cmd:python3 own/team.py' idle --pairs 1 --half-seconds 1";
  for (const bool folder : {false, true}) {
    fs::remove(box.path / "own/team.toml");
    if (folder) fs::create_directory(box.path / "own/team.toml");
    if (!folder) ::mkfifo((box.path / "own/team.toml").c_str(), 0600);
    refused(play, "own/team.toml': " + std::string(folder ? "Is a directory" : "it is not a regular file"));
  }
  fs::create_directory(box.path / "drills");
  ::mkfifo((box.path / "drills/1.toml").c_str(), 0600);
  refused("drill idle --drills drills", "drills/1.toml': it is not a regular file");
  fs::create_directory(box.path / "results");
  ::mkfifo((box.path / "results/plan.json").c_str(), 0600);
  refused("tournament report results", "results/plan.json': it is not a regular file");
}
