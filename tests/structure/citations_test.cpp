#include "tests/structure/citations.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include "tests/structure/text_of.hpp"
#include "tests/support/catch.hpp"

// Whatever a comment, a preset, a help text or a page cites can be looked up: in this repository, or in a
// paper or rule book that it names.
namespace fulbito::test {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

constexpr std::array kExtensions = {".hpp", ".cpp", ".toml", ".md",  ".txt",  ".cmake", ".in",
                                    ".sh",  ".js",  ".mjs",  ".css", ".html", ".c",     ".h"};

/// What the program and npm write, as .gitignore lists it.
constexpr std::array kWritten = {"out", "fulbito-out", "render-gallery", "node_modules"};

/// Files that people read; build trees, hidden folders and what is written are left out.
std::vector<fs::path> readableFiles() {
  std::vector<fs::path> files;
  auto entry = fs::recursive_directory_iterator(FULBITO_SOURCE_DIR);
  for (; entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string name = entry->path().filename();
    const bool is_written = std::count(kWritten.begin(), kWritten.end(), name) > 0;
    if (entry->is_directory() && (name.starts_with('.') || name.starts_with("build") || is_written))
      entry.disable_recursion_pending();
    const std::string extension = entry->path().extension();
    if (entry->is_regular_file() && std::count(kExtensions.begin(), kExtensions.end(), extension) > 0)
      files.push_back(entry->path());
  }
  return files;
}

bool isPageOfRepository(const fs::path& file, std::string page) {
  while (page.starts_with('/')) page.erase(0, 1);
  const fs::path root = FULBITO_SOURCE_DIR;
  return fs::exists(root / page) || fs::exists(root / "docs" / page) || fs::exists(file.parent_path() / page);
}

}  // namespace

TEST_CASE("nothing cites a page or a numbering that is not in the repository", "[unit]") {
  const std::vector<fs::path> files = readableFiles();
  CHECK(files.size() > 700);
  for (const fs::path& file : files) {
    const std::string name = fs::relative(file, FULBITO_SOURCE_DIR);
    if (name.starts_with("tests/structure/citations")) continue;  // they hold what is sought
    std::ifstream in(file);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
      ++number;
      const std::string where = name + ":" + std::to_string(number) + " cites ";
      for (const std::string& word : privateCitationsIn(line)) FAIL_CHECK(where + word);
      // Scripts write pages of their own.
      if (file.extension() == ".sh") continue;
      for (const std::string& page : pagesNamedIn(line)) {
        if (!isPageOfRepository(file, page)) FAIL_CHECK(where + page);
      }
    }
  }
}

TEST_CASE("docs/drills.md gives each drill's source as the drill's file does", "[unit]") {
  const std::string page = textOf(fs::path(FULBITO_SOURCE_DIR) / "docs" / "drills.md");
  const std::string key = "\nsource = \"";
  int drills = 0;
  for (const auto& entry :
       fs::directory_iterator(fs::path(FULBITO_SOURCE_DIR) / "match" / "drills" / "definitions")) {
    const std::string drill = textOf(entry.path());
    INFO(entry.path().filename().string());
    REQUIRE(drill.find(key) != std::string::npos);
    const std::size_t begin = drill.find(key) + key.size();
    CHECK(page.find("| " + drill.substr(begin, drill.find("\"\n", begin) - begin) + " |\n") !=
          std::string::npos);
    ++drills;
  }
  CHECK(drills == 21);
}

TEST_CASE("private citations are found, and names that look like them are not", "[unit]") {
  CHECK(privateCitationsIn("/// the first meeting (STRATEGY 2.3), see NAVIGATION-BENCH") ==
        Words{"NAVIGATION-BENCH", "STRATEGY"});
  CHECK(privateCitationsIn("N1: as paper 004 (1), erratum E24, row R4-a") ==
        Words{"N1", "E24", "R4-a", "paper 0"});
  CHECK(privateCitationsIn("\"paper-004\" of the strategy page, the reference page") ==
        Words{"reference page", "strategy page", "paper-0"});
  CHECK(privateCitationsIn(
            "navigation, FULBITO_PHYSICS_STEP, 1E12, N, [PHYSICS], E0, R2D2, paper 1, R4-A, NE12")
            .empty());
  CHECK(pagesNamedIn("(docs/drills.md), [x](strategies.md#skills). See STRATEGY.md. a.mdx .md") ==
        Words{"docs/drills.md", "strategies.md", "STRATEGY.md"});
  CHECK(isPageOfRepository(fs::path(FULBITO_SOURCE_DIR) / "docs" / "drills.md", "strategies.md"));
  CHECK_FALSE(isPageOfRepository(fs::path(FULBITO_SOURCE_DIR) / "docs" / "drills.md", "STRATEGY.md"));
}

}  // namespace fulbito::test
