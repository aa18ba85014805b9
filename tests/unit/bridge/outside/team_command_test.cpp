#include "bridge/outside/team_command.hpp"

#include <filesystem>
#include <fstream>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

std::vector<std::string> words(const std::string& specification) {
  const auto line = parseTeamCommand(specification);
  REQUIRE(line);
  return line->command;
}

std::string refusal(const std::string& specification) {
  const auto line = parseTeamCommand(specification);
  REQUIRE_FALSE(line);
  CHECK(line.error().code == ErrorCode::kUsage);
  return line.error().message;
}

TEST_CASE("a specification names a file or a program, or else a team of the catalogue", "[unit]") {
  for (const char* outside : {"cmd:./x", "cmd:python3 x.py", "./x.so", "x.so", "teams/x.so:a=1", "./x"}) {
    CHECK(isOutside(outside));
  }
  for (const char* inside : {"libero", "libero:navigator=bezier", "classic:navigator=./mine.so:mine", "so"}) {
    CHECK_FALSE(isOutside(inside));
  }
}

TEST_CASE("words of a program's command are split as a shell splits them", "[unit]") {
  const auto found = words("cmd:sh  -c 'a  b' \"it's\" c\\ d '' e\"f\"'g'");
  REQUIRE(found.size() == 7);
  CHECK(std::filesystem::path(found[0]).filename() == "sh");
  CHECK(found[1] == "-c");
  CHECK(found[2] == "a  b");
  CHECK(found[3] == "it's");
  CHECK(found[4] == "c d");
  CHECK(found[5].empty());
  CHECK(found[6] == "efg");
}

TEST_CASE("arguments that name files become absolute, and the team's folder is that of its first file",
          "[unit]") {
  const ScratchFolder folder;
  const std::string file = folder.write("team.py", "print()\n");
  const std::string relative = std::filesystem::relative(file).string();
  const auto line = parseTeamCommand("cmd:sh " + relative + " --fast");
  REQUIRE(line);
  CHECK(line->command[1] == file);
  CHECK(line->command[2] == "--fast");
  CHECK(line->folder == std::filesystem::absolute(std::filesystem::path(line->command[1]).parent_path()));
}

TEST_CASE("the folder of a program by its path is the team's, unless it is installed in a folder `bin`",
          "[unit]") {
  const ScratchFolder folder;
  namespace fs = std::filesystem;
  fs::create_directories(folder.path() / "bin");
  fs::create_directories(folder.path() / "data");
  const std::string own = folder.write("team", "#!/bin/sh\n"),
                    installed = folder.write("bin/run", "#!/bin/sh\n");
  const std::string file = folder.write("data/net", "1");
  for (const std::string& program : {own, installed}) fs::permissions(program, fs::perms::owner_all);
  const auto folderOf = [](const std::string& command) {
    const auto line = parseTeamCommand("cmd:" + command);
    REQUIRE(line);
    return line->folder;
  };
  const std::string root = fs::absolute(folder.path()).string();
  CHECK(folderOf(own) == root);
  CHECK(folderOf(own + " " + file) == root);
  CHECK(folderOf(installed + " --fast " + file) == root + "/data");
  CHECK(folderOf(installed) == root + "/bin");
  CHECK(folderOf("sh -c true").empty());
}

TEST_CASE("the hash of a team is that of its files", "[unit]") {
  const ScratchFolder folder;
  std::string file = folder.write("team.py", "print(0)\n");
  std::ofstream(file) << "print(1)\n";
  const auto first = parseTeamCommand("cmd:sh " + file);
  std::ofstream(file) << "print(2)\n";
  const auto second = parseTeamCommand("cmd:sh " + file);
  REQUIRE((first && second));
  CHECK(first->hash.size() == 16);
  CHECK(first->hash != second->hash);
}

TEST_CASE("wrong specifications name what is wrong", "[unit]") {
  CHECK(refusal("./nowhere.so") == "team './nowhere.so': there is no file './nowhere.so'");
  CHECK(refusal("cmd:") == "team 'cmd:': there is no program after 'cmd:'");
  CHECK(refusal("cmd:no-such-program-at-all") ==
        "team 'cmd:no-such-program-at-all': there is no program 'no-such-program-at-all' in PATH");
  CHECK(refusal("cmd:sh 'x") == "team 'cmd:sh 'x': a quote is not closed: '");
  const ScratchFolder folder;
  const std::string file = folder.write("team", "#!/bin/sh\n");
  CHECK(refusal("cmd:" + file).find("is not executable") != std::string::npos);
  CHECK(refusal(file + ":speed").find("speed") != std::string::npos);
}

}  // namespace
}  // namespace fulbito
