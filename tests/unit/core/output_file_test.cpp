#include "engine/core/output_file.hpp"

#include <filesystem>
#include <fstream>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

namespace fs = std::filesystem;

struct TemporaryFolder {
  fs::path path = fs::temp_directory_path() / ("fulbito-output-" + std::to_string(::getpid()));
  TemporaryFolder() { fs::create_directories(path); }
  ~TemporaryFolder() { fs::remove_all(path); }
};

std::string contentOf(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a file is written whole and replaces the old one", "[unit]") {
  const TemporaryFolder folder;
  const std::string file = folder.path / "a.txt";
  REQUIRE(writeFile(file, "one"));
  REQUIRE(writeFile(file, "two"));
  CHECK(contentOf(file) == "two");
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("a file that cannot be written is named and leaves nothing behind", "[unit]") {
  const TemporaryFolder folder;
  const auto missing = writeFile(folder.path / "no" / "a.txt", "x");
  REQUIRE_FALSE(missing);
  CHECK(missing.error().code == ErrorCode::kIo);
  CHECK(missing.error().message.find("a.txt': there is no folder '") != std::string::npos);
  REQUIRE(writeFile(folder.path / "file", "x"));
  const auto below = writeFile(folder.path / "file" / "a.txt", "x");
  REQUIRE_FALSE(below);
  CHECK(below.error().message.find("file' is not a folder") != std::string::npos);
  fs::remove(folder.path / "file");
  fs::create_directories(folder.path / "b.txt" / "inside");
  CHECK_FALSE(writeFile(folder.path / "b.txt", "x"));
  CHECK(std::distance(fs::directory_iterator(folder.path), {}) == 1);
}

TEST_CASE("a device is written to, not replaced", "[unit]") {
  CHECK(writeFile("/dev/null", "x"));
  CHECK(std::filesystem::is_character_file("/dev/null"));
  const auto full = writeFile("/dev/full", "x");
  REQUIRE_FALSE(full);
  CHECK(full.error().code == ErrorCode::kIo);
  CHECK(std::filesystem::is_character_file("/dev/full"));
}

TEST_CASE("an output folder is made, or the error names it", "[unit]") {
  const TemporaryFolder folder;
  CHECK(prepareFolder(folder.path / "deep" / "er"));
  CHECK(fs::is_empty(folder.path / "deep" / "er"));
  REQUIRE(writeFile(folder.path / "file", "x"));
  const auto blocked = prepareFolder(folder.path / "file" / "below");
  REQUIRE_FALSE(blocked);
  CHECK(blocked.error().code == ErrorCode::kIo);
  CHECK(blocked.error().message.find("file/below") != std::string::npos);
  CHECK_FALSE(prepareFolder("/proc/fulbito"));
}

}  // namespace fulbito
