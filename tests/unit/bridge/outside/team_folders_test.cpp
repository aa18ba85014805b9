// The files that teams can read, wherever the program and the team's files are.

#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <sys/syscall.h>
#include <unistd.h>

#include "fulbito/outside.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/team_memory.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;
namespace fs = std::filesystem;

/// A start that fails: all standard error of the team is shown.
struct Start {
  std::string log;
  std::string error;
};

Start startOf(const std::string& specification, const std::string& host = FULBITO_TEAM_HOST) {
  Start start;
  OutsideOptions options;
  options.host = host;
  options.limits.memory = kTeamMemory;
  options.clock = [] { return std::chrono::steady_clock::now().time_since_epoch().count(); };
  options.log = [&start](const std::string&, std::string_view line) {
    start.log += std::string(line) + "\n";
  };
  TeamCatalogue teams = TeamCatalogue::builtIn();
  teams.addSource(outsideTeams(options));
  if (const auto choice = teams.parse(specification); !choice) start.error = choice.error().message;
  return start;
}

/// Without Landlock, mounts prevent writing, but a team reads all that its user can read.
bool hidesFiles() { return ::syscall(SYS_landlock_create_ruleset, nullptr, 0, 1U) >= 1; }

std::string copied(const char* file, const fs::path& to) {
  fs::create_directories(to.parent_path());
  fs::copy_file(file, to);
  return to.string();
}

void put(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

}  // namespace

TEST_CASE("a library reads its own folder and nothing around the program that hosts it", "[unit]") {
  if (!hidesFiles()) return;
  const ScratchFolder scratch;
  const fs::path root = scratch.path();
  // Folders below the root: that of the program, and that of the library.
  const std::pair<const char*, const char*> layouts[] = {{"user/bin", "elsewhere"},
                                                         {"user", "elsewhere"},
                                                         {"user", "user/teams/a"},
                                                         {"x/bin", "x/share/a"},
                                                         {"deep/a/b/bin", "deep/a"}};
  int number = 0;
  for (const auto& [program, own] : layouts) {
    INFO(program << " and " << own);
    const fs::path folder = root / std::to_string(++number);
    const std::string host = copied(FULBITO_TEAM_HOST, folder / program / "fulbito-team-host");
    const std::string library =
        copied(FULBITO_TEST_LIBRARIES "/reading.so", folder / own / "team" / "reading.so");
    const fs::path secrets[] = {folder / program / ".." / "above", folder / program / "beside",
                                folder / program / "below" / "key", folder / own / "team-of-others"};
    std::string paths = "model.bin\n";
    for (const fs::path& secret : secrets) {
      put(secret, "secret");
      paths += secret.string() + "\n";
    }
    put(folder / own / "team" / "model.bin", "mine");
    put(folder / own / "team" / "paths.txt", paths);
    fs::create_symlink(host, folder / "host-link");
    for (const std::string& started : {host, (folder / "host-link").string()}) {
      const Start start = startOf(library, started);
      CHECK(start.error.find("refuses to be made") != std::string::npos);
      CHECK(start.log.find("reads model.bin\n") != std::string::npos);
      for (const fs::path& secret : secrets) {
        CHECK(start.log.find("lacks " + secret.string() + "\n") != std::string::npos);
      }
    }
  }
}

TEST_CASE("a library behind a symbolic link starts, and the folder behind the link stays hidden", "[unit]") {
  const ScratchFolder scratch;
  const fs::path root = scratch.path();
  copied(FULBITO_TEST_LIBRARIES "/reading.so", root / "builds" / "reading.so");
  put(root / "builds" / "notes.txt", "secret");
  put(root / "team" / "paths.txt", (root / "builds" / "notes.txt").string() + "\n");
  fs::create_symlink(root / "builds" / "reading.so", root / "team" / "team.so");
  const Start start = startOf((root / "team" / "team.so").string());
  CHECK(start.error.find("refuses to be made") != std::string::npos);
  CHECK((start.log.find("lacks ") != std::string::npos || !hidesFiles()));
}

TEST_CASE("the folder of a script is its team's own, however its interpreter is named", "[unit]") {
  const ScratchFolder scratch;
  const fs::path root = scratch.path();
  put(root / "team" / "words.txt", "found\n");
  put(root / "team" / "run.sh", "cat words.txt >&2; cat \"$1\" >&2; exit 3\n");
  put(root / "models" / "net.bin", "net\n");
  put(root / "models" / "other.bin", "other\n");
  const std::string script = (root / "team" / "run.sh").string();
  const std::string model = (root / "models" / "net.bin").string();
  for (const std::string interpreter : {"sh", "/bin/sh"}) {
    CHECK(startOf("cmd:" + interpreter + " " + script + " " + model).log == "found\nnet\n");
  }
  // A file that the command names is readable, the files beside it are not.
  put(root / "team" / "run.sh", "cat \"$(dirname \"$1\")/other.bin\" >&2; exit 3\n");
  const std::string log = startOf("cmd:sh " + script + " " + model).log;
  CHECK((log.find("ermission denied") != std::string::npos || !hidesFiles()));
}

TEST_CASE("a team that does not start because a file of its command is missing says which", "[unit]") {
  const ScratchFolder scratch;
  const std::string missing = (scratch.path() / "nowhere.sh").string();
  CHECK(startOf("cmd:sh " + missing).error.ends_with("there is no file '" + missing + "'"));
  CHECK(startOf("cmd:sh team-x.sh")
            .error.ends_with("; there is no file 'team-x.sh' in " + fs::current_path().string()));
  // Other words are not taken for files.
  CHECK(startOf("cmd:sh -c 'exit 4' --rate=0.5 fast").error.ends_with("exit code 4"));
}

}  // namespace fulbito
