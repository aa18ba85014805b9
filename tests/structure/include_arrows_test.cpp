#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/structure/arrows.hpp"
#include "tests/structure/text_of.hpp"
#include "tests/support/catch.hpp"

namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPairs = 20;

const std::set<std::string> kKnownLibraries = {
    "fmt",          "tl",        "toml++",   "Random123", "xxhash.h",
    "box2d",        "SDL.h",     "SDL2",     "SDL_ttf.h", "SDL2_gfxPrimitives.h",
    "png.h",        "nlohmann",  "CLI",      "Eigen",     "zlib.h",
    "libdeflate.h", "gif_lib.h", "seccomp.h"};

std::string folderOf(const std::string& path) { return fs::path(path).parent_path().string(); }

const Folder* find(const std::string& path) {
  const auto all = folders();
  const auto at = std::find_if(all.begin(), all.end(), [&](const Folder& f) { return f.path == path; });
  return at == all.end() ? nullptr : &*at;
}

bool has(const std::vector<std::string_view>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What a source includes: with quotes, or else with angle brackets.
std::vector<std::string> includesOf(const std::string& text, bool quoted) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, include) && (match[1] == "\"") == quoted) found.push_back(match[2]);
  }
  return found;
}

bool isPublic(const std::string& path) { return path.starts_with(kPublicFolder); }

std::vector<std::string> violations(const std::string& path, const std::string& text) {
  const Folder* folder = find(ownerOf(path));
  if (folder == nullptr) return {path + " is in a folder that arrows.cpp lacks"};
  std::vector<std::string> found;
  for (const std::string& target : includesOf(text, true)) {
    const std::string other = ownerOf(target);
    if (other != folder->path && !has(folder->uses, other)) found.push_back(path + " -> " + target);
  }
  for (const std::string& target : includesOf(text, false)) {
    const std::string library = target.substr(0, target.find('/'));
    if (kKnownLibraries.count(library) == 0 || library == "tl") continue;
    if (isPublic(path)) found.push_back(path + " (a public header) -> " + target);
    if (!has(libraryOf(folder->path)->others, library)) found.push_back(path + " -> " + target);
  }
  return found;
}

/// Every source below some folders, as its path from the root.
std::vector<std::string> sourcesBelow(const std::vector<std::string_view>& tops) {
  std::vector<std::string> found;
  std::set<std::string> seen;
  for (std::string_view top : tops) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FULBITO_SOURCE_DIR) / top)) {
      const std::string extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      const std::string path = fs::relative(entry.path(), FULBITO_SOURCE_DIR);
      if (seen.insert(path).second) found.push_back(path);
    }
  }
  return found;
}

/// Those of the libraries and the public headers.
std::vector<std::string> sources() {
  std::vector<std::string_view> tops{kPublicFolder};
  for (const Library& library : libraries()) tops.push_back(library.folder);
  return sourcesBelow(tops);
}

std::string textAt(const std::string& path) { return textOf(fs::path(FULBITO_SOURCE_DIR) / path); }

/// Whether one can come from `from` to `to` along the arrows.
bool reaches(const std::string& from, const std::string& to, std::set<std::string>& seen) {
  const Folder* folder = find(from);
  return std::any_of(folder->uses.begin(), folder->uses.end(), [&](std::string_view used) {
    const std::string next(used);
    return next == to || (seen.insert(next).second && reaches(next, to, seen));
  });
}

/// What each library of the build links, by the names after `fulbito::`.
std::map<std::string, std::set<std::string>> links() {
  static const std::regex library(R"(fulbito_library\((\w+)([^)]*)\))"), linked(R"(fulbito::(\w+))");
  std::map<std::string, std::set<std::string>> found;
  for (const Library& l : libraries()) {
    const std::string text = textAt(std::string(l.folder) + "/CMakeLists.txt");
    std::smatch match;
    if (!std::regex_search(text, match, library)) continue;
    const std::string names = match[2];
    for (std::sregex_iterator it(names.begin(), names.end(), linked), end; it != end; ++it)
      found[match[1]].insert((*it)[1]);
  }
  return found;
}

/// A library's name without `fulbito::`; empty for what is none of the installed libraries.
std::string nameOf(const Library& library) {
  const std::size_t colons = library.target.find("::");
  return colons == std::string::npos ? std::string() : std::string(library.target.substr(colons + 2));
}

/// The libraries whose folders those of `name` include from.
std::set<std::string> usedBy(const std::string& name) {
  std::set<std::string> used;
  for (const Folder& folder : folders()) {
    if (nameOf(*libraryOf(folder.path)) != name) continue;
    for (std::string_view other : folder.uses) used.insert(nameOf(*libraryOf(other)));
  }
  used.erase(name);
  used.erase("");  // folders of headers alone are in no library
  return used;
}

}  // namespace

TEST_CASE("includes follow the arrows of the architecture", "[unit]") {
  const auto files = sources();
  CHECK(files.size() > 500);
  for (const std::string& path : files) {
    for (const std::string& v : violations(path, textAt(path))) FAIL_CHECK(v);
  }
}

TEST_CASE("every arrow of the architecture is needed by an include", "[unit]") {
  std::set<std::string> used;
  for (const std::string& path : sources()) {
    for (const std::string& target : includesOf(textAt(path), true))
      used.insert(ownerOf(path) + " -> " + ownerOf(target));
  }
  for (const Folder& folder : folders()) {
    for (std::string_view other : folder.uses) {
      const std::string arrow = std::string(folder.path) + " -> " + std::string(other);
      INFO(arrow);
      CHECK(used.count(arrow) == 1);
    }
  }
}

TEST_CASE("no folder comes back to itself along the arrows", "[unit]") {
  for (const Folder& folder : folders()) {
    std::set<std::string> seen;
    INFO(folder.path);
    CHECK_FALSE(reaches(std::string(folder.path), std::string(folder.path), seen));
  }
}

TEST_CASE("the build links each library with those that its arrows name", "[unit]") {
  const auto linked = links();
  CHECK(linked.size() > 8);
  for (const auto& [name, direct] : linked) {
    const std::set<std::string> used = usedBy(name);
    for (const std::string& other : direct) {
      INFO("fulbito::" << name << " links fulbito::" << other);
      CHECK(used.count(other) == 1);
    }
    for (const std::string& other : used) {
      bool found = direct.count(other) == 1;
      for (const std::string& between : direct) found = found || usedBy(between).count(other) == 1;
      INFO("fulbito::" << name << " includes from fulbito::" << other);
      CHECK(found);
    }
  }
}

TEST_CASE("no folder holds so many files that a reader loses the way", "[unit]") {
  std::map<std::string, std::set<std::string>> names;
  for (const std::string& path : sources()) {
    names[folderOf(path)].insert(fs::path(path).stem().string());
  }
  for (const auto& [folder, stems] : names) {
    if (folder == "tests/support" || isPublic(folder)) continue;
    INFO(folder);
    CHECK(stems.size() <= kMostPairs);
  }
}

TEST_CASE("every folder of unit tests has the folder of the sources that it tests", "[unit]") {
  const fs::path root = FULBITO_SOURCE_DIR, tests = root / "tests/unit";
  int files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(tests)) {
    if (entry.path().extension() != ".cpp") continue;
    ++files;
    INFO(entry.path());
    CHECK(fs::is_directory(root / fs::relative(entry.path().parent_path(), tests)));
  }
  CHECK(files > 100);
}

TEST_CASE("the tables of docs/architecture.md are those of the arrows", "[unit]") {
  const std::string page = textAt("docs/architecture.md");
  INFO("print them with the program arrow_table and put them between the marks of docs/architecture.md");
  CHECK(page.find("-->\n\n" + arrowTables() + "\n<!-- /arrows -->\n") != std::string::npos);
}

TEST_CASE("the walk finds a wrong arrow", "[unit]") {
  const std::string vec2 = "#include \"fulbito/detail/vec2.hpp\"\n";
  CHECK(violations("engine/core/math/x.cpp", vec2).empty());
  CHECK(violations("engine/core/base/x.cpp", "#include \"fulbito/world.hpp\"\n").size() == 1);
  CHECK(violations("engine/core/base/x.cpp", "#include \"fulbito/detail/math.hpp\"\n").size() == 1);
  CHECK(violations("referee/rules/x.cpp", "#include \"fulbito/navigation.hpp\"\n").size() == 1);
  CHECK(violations("referee/rules/x.cpp", "#include <box2d/box2d.h>\n").size() == 1);
  CHECK(violations("sdk/include/fulbito/world.hpp", "#include <box2d/box2d.h>\n").size() == 1);
  CHECK(violations("engine/sim/x.cpp", "#include <box2d/box2d.h>\n#include <vector>\n").empty());
  CHECK(violations("referee/nowhere/x.cpp", vec2).size() == 1);
}

}  // namespace fulbito::test
