#include "tournament/identity/file_set.hpp"

#include <filesystem>
#include <fstream>
#include <sys/stat.h>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"

namespace fulbito {

TEST_CASE("patterns stand for names, folders and all below", "[unit]") {
  CHECK(matchesPattern("*.py", "team.py"));
  CHECK_FALSE(matchesPattern("*.py", "a/team.py"));
  CHECK_FALSE(matchesPattern("*.py", "team.pyc"));
  CHECK(matchesPattern("team.?y", "team.py"));
  CHECK(matchesPattern("[a-z]*.py", "team.py"));
  CHECK(matchesPattern("**", "a/b/c"));
  CHECK(matchesPattern("**/*.py", "team.py"));
  CHECK(matchesPattern("**/*.py", "a/b/team.py"));
  CHECK(matchesPattern("weights/**", "weights/a/b.bin"));
  CHECK(matchesPattern("weights/**/*.bin", "weights/b.bin"));
  CHECK_FALSE(matchesPattern("weights/**", "weights"));
  CHECK_FALSE(matchesPattern("weights/**", "other/b.bin"));
  CHECK_FALSE(matchesPattern("*", ".hidden"));
}

TEST_CASE("a file is hashed piece by piece", "[unit]") {
  const test::ScratchFolder scratch;
  const auto file = scratch.path() / "large";
  std::string text;
  for (int i = 0; text.size() < (std::size_t{1} << 20); ++i) text += std::to_string(i);
  std::ofstream(file, std::ios::binary) << text;
  const auto hash = fileHash(file);
  REQUIRE(hash);
  CHECK(*hash == wideHash(text));
  text.back() ^= 1;
  std::ofstream(file, std::ios::binary) << text;
  CHECK(*fileHash(file) != *hash);
  const auto missing = fileHash(scratch.path() / "missing");
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == ErrorCode::kIo);
  CHECK(missing.error().message.find("missing") != std::string::npos);
  // Opening a pipe would wait forever.
  const std::string pipe = (scratch.path() / "pipe").string();
  REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
  CHECK(fileHash(pipe).error().message == "cannot read '" + pipe + "': it is no regular file");
}

TEST_CASE("links to folders and hidden names do not belong to a set of files", "[unit]") {
  const test::ScratchFolder scratch;
  const std::filesystem::path folder = scratch.path() / "team";
  for (const char* file :
       {"team/a.py", "team/.git/b.py", "team/__pycache__/c.py", "team/.d.py", "other/e.py"})
    scratch.write(file, "");
  std::filesystem::create_directory_symlink(scratch.path() / "other", folder / "linked");
  const auto files = filesMatching(folder, {"**"});
  REQUIRE(files);
  CHECK(*files == std::set<std::string>{"a.py"});
}

}  // namespace fulbito
