#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "tests/structure/public_headers.hpp"
#include "tests/structure/text_of.hpp"
#include "tests/support/catch.hpp"

// Who may include from whom: a folder from the libraries that its CMakeLists.txt links and from what these
// link, but for what is forbidden below; and never in a circle.
namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostPairs = 20;

const std::vector<std::string_view> kRooms = {"engine",      "navigation", "strategies", "referee",
                                              "replays",     "match",      "bridge",     "tournament",
                                              "experiments", "bench",      "apps",       "python"};

/// What no folder of a room may include, whatever the build links: who plays knows nothing of who looks on,
/// and so on.
const std::map<std::string_view, std::vector<std::string_view>> kForbidden = {
    {"engine",
     {"navigation", "strategies", "referee", "replays", "match", "bridge", "tournament", "experiments",
      "bench", "apps"}},
    {"navigation",
     {"engine/sim", "strategies", "referee", "replays", "match", "bridge", "tournament", "experiments",
      "apps"}},
    {"referee",
     {"engine/sim", "navigation", "strategies", "replays", "match", "bridge", "tournament", "experiments",
      "apps"}},
    {"strategies", {"engine/sim", "replays", "match", "bridge", "tournament", "experiments", "apps"}},
    {"replays", {"navigation", "strategies", "match", "bridge", "tournament", "experiments", "apps"}},
    {"match", {"replays/render", "replays/html", "bridge", "tournament", "experiments", "apps"}},
    {"bridge", {"engine/sim", "replays", "match", "tournament", "experiments", "apps"}},
    {"experiments", {"strategies", "match", "bridge", "tournament", "apps"}},
    {"tournament", {"apps"}},
    {"apps", {"python"}},
    {"python", {"apps"}},
};

/// The experiments of papers show that others can write one outside of this project: they include public
/// headers and their own, and nothing else.
constexpr std::string_view kPapers = "experiments/papers";

/// How the files of the build name what third-party headers come from.
const std::map<std::string, std::string> kThirdParty = {{"fmt", "fmt::fmt"},
                                                        {"toml++", "TOMLPLUSPLUS"},
                                                        {"Random123", "RANDOM123"},
                                                        {"xxhash.h", "XXHASH"},
                                                        {"box2d", "box2d::box2d"},
                                                        {"SDL.h", "SDL2"},
                                                        {"SDL2", "SDL2"},
                                                        {"SDL_ttf.h", "SDL2_ttf"},
                                                        {"SDL2_gfxPrimitives.h", "SDL2"},
                                                        {"png.h", "PNG::PNG"},
                                                        {"nlohmann", "nlohmann_json"},
                                                        {"CLI", "CLI11"},
                                                        {"Eigen", "Eigen3"},
                                                        {"zlib.h", "ZLIB"},
                                                        {"libdeflate.h", "libdeflate"},
                                                        {"gif_lib.h", "GIF::GIF"},
                                                        {"seccomp.h", "SECCOMP"},
                                                        {"nanobind", "nanobind"}};

using Names = std::set<std::string>;

/// What the CMakeLists.txt of a folder says.
struct Library {
  std::string text;
  Names targets;  ///< without `fulbito_`
  Names links;    ///< targets of other folders, likewise
};

std::string textAt(const std::string& path) { return textOf(fs::path(FULBITO_SOURCE_DIR) / path); }

std::string folderOf(const std::string& path) { return fs::path(path).parent_path().string(); }

bool isIn(std::string_view path, std::string_view folder) {
  return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

bool isPublic(const std::string& path) { return path.starts_with(kPublicFolder); }

Names matches(const std::string& text, const std::regex& pattern) {
  Names found;
  for (std::sregex_iterator at(text.begin(), text.end(), pattern), end; at != end; ++at)
    found.insert((*at)[1]);
  return found;
}

/// Every file of the rooms and of the public headers, as its path from the root.
std::vector<std::string> filesOfRooms() {
  std::vector<std::string_view> tops = kRooms;
  tops.push_back(kPublicFolder);
  std::vector<std::string> found;
  for (std::string_view top : tops) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FULBITO_SOURCE_DIR) / top)) {
      found.push_back(fs::relative(entry.path(), FULBITO_SOURCE_DIR));
    }
  }
  return found;
}

const std::vector<std::string>& sources() {
  static const std::vector<std::string> kSources = [] {
    std::vector<std::string> found = filesOfRooms();
    std::erase_if(found,
                  [](const std::string& path) { return !path.ends_with(".cpp") && !path.ends_with(".hpp"); });
    return found;
  }();
  return kSources;
}

/// Libraries and programs of the build, by folder.
const std::map<std::string, Library>& libraries() {
  static const std::map<std::string, Library> kLibraries = [] {
    static const std::regex comment("#[^\n]*"),
        target(R"((?:fulbito_library|fulbito_internal_library|add_executable)\((?:fulbito[_-])?([\w-]+))"),
        linked(R"(fulbito(?:::|_)(\w+))");
    std::map<std::string, Library> found;
    for (const std::string& path : filesOfRooms()) {
      if (fs::path(path).filename() != "CMakeLists.txt") continue;
      Library library{std::regex_replace(textAt(path), comment, ""), {}, {}};
      library.targets = matches(library.text, target);
      library.links = matches(library.text, linked);
      found[folderOf(path)] = library;
    }
    return found;
  }();
  return kLibraries;
}

/// The folder of the innermost library that a folder is in; empty where it is in none, as headers alone may
/// be.
std::string libraryOf(const std::string& folder) {
  for (fs::path path = folder; !path.empty(); path = path.parent_path()) {
    if (libraries().contains(path)) return path;
  }
  return {};
}

std::string libraryOfTarget(const std::string& target) {
  for (const auto& [folder, library] : libraries()) {
    if (library.targets.contains(target)) return folder;
  }
  return {};
}

/// The folders of the libraries that one links, and of those that these link.
void addLinked(const std::string& folder, Names& all) {
  for (const std::string& target : libraries().at(folder).links) {
    const std::string other = libraryOfTarget(target);
    if (!other.empty() && other != folder && all.insert(other).second) addLinked(other, all);
  }
}

/// What a source includes: with quotes, or else with angle brackets.
std::vector<std::string> includesOf(const std::string& text, bool quoted) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.find("include") == std::string::npos) continue;
    std::smatch match;
    if (std::regex_search(line, match, include) && (match[1] == "\"") == quoted) found.push_back(match[2]);
  }
  return found;
}

/// The folders that each folder includes from.
const std::map<std::string, Names>& arrows() {
  static const std::map<std::string, Names> kArrows = [] {
    std::map<std::string, Names> found;
    for (const std::string& path : sources()) {
      Names& used = found[ownerOf(path)];
      for (const std::string& target : includesOf(textAt(path), true)) used.insert(ownerOf(target));
      used.erase(ownerOf(path));
    }
    return found;
  }();
  return kArrows;
}

/// Whether one can come from `from` to `to` along the arrows.
bool reaches(const std::string& from, const std::string& to, Names& seen) {
  const auto used = arrows().find(from);
  return used != arrows().end() &&
         std::any_of(used->second.begin(), used->second.end(), [&](const std::string& next) {
           return next == to || (seen.insert(next).second && reaches(next, to, seen));
         });
}

/// Why a folder may not include from another; empty where it may.
std::string objection(const std::string& from, const std::string& to) {
  for (const auto& [room, forbidden] : kForbidden) {
    for (std::string_view other : forbidden) {
      if (isIn(from, room) && isIn(to, other)) return "forbidden";
    }
  }
  const std::string library = libraryOf(from), other = libraryOf(to);
  Names linked{library, ""};
  if (!library.empty()) addLinked(library, linked);
  if (!library.empty() && !linked.contains(other)) return "the build does not link " + other;
  Names seen;
  return reaches(to, from, seen) ? "a circle" : "";
}

std::vector<std::string> violations(const std::string& path, const std::string& text) {
  const std::string folder = ownerOf(path);
  if (!arrows().contains(folder)) return {path + " is in a folder without sources"};
  std::vector<std::string> found;
  for (const std::string& target : includesOf(text, true)) {
    if (isIn(folder, kPapers) && !isIn(target, kPapers) && folderOf(target) != "fulbito") {
      found.push_back(path + " -> " + target + ": no public header");
    }
    const std::string other = ownerOf(target);
    const std::string why = other == folder ? "" : objection(folder, other);
    if (!why.empty()) found.push_back(path + " -> " + target + ": " + why);
  }
  for (const std::string& target : includesOf(text, false)) {
    const auto third_party = kThirdParty.find(target.substr(0, target.find('/')));
    if (third_party == kThirdParty.end()) continue;
    const std::string library = libraryOf(folder);
    const bool linked =
        !library.empty() && libraries().at(library).text.find(third_party->second) != std::string::npos;
    if (isPublic(path) || !linked) found.push_back(path + " -> " + target);
  }
  return found;
}

}  // namespace

TEST_CASE("includes follow the arrows of the architecture", "[unit]") {
  CHECK(sources().size() > 500);
  CHECK(libraries().size() > 20);
  for (const std::string& path : sources()) {
    for (const std::string& v : violations(path, textAt(path))) FAIL_CHECK(v);
  }
}

TEST_CASE("each library links only what its sources include from", "[unit]") {
  for (const auto& [folder, library] : libraries()) {
    if (library.text.find("fulbito_library(") == std::string::npos) continue;
    Names used;
    for (const auto& [from, others] : arrows()) {
      if (libraryOf(from) != folder) continue;
      for (const std::string& other : others) used.insert(libraryOf(other));
    }
    for (const std::string& target : library.links) {
      const std::string other = libraryOfTarget(target);
      INFO(folder << " links " << target);
      CHECK((other.empty() || other == folder || used.contains(other)));
    }
  }
}

TEST_CASE("no folder holds so many files that a reader loses the way", "[unit]") {
  std::map<std::string, Names> names;
  for (const std::string& path : sources()) names[folderOf(path)].insert(fs::path(path).stem().string());
  for (const auto& [folder, stems] : names) {
    if (isPublic(folder)) continue;
    INFO(folder);
    CHECK(stems.size() <= kMostPairs);
  }
}

TEST_CASE("docs/architecture.md has a row for each folder with sources", "[unit]") {
  static const std::regex row(R"(\n\| `([a-z_/]+)` \| )");
  Names there;
  for (const auto& [folder, used] : arrows()) there.insert(folder);
  there.insert("tests/support");
  const std::string page = textAt("docs/architecture.md");
  const std::size_t table = page.find("All folders with sources");
  REQUIRE(table != std::string::npos);
  CHECK(matches(page.substr(table, page.find("\n## ", table) - table), row) == there);
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
  CHECK(violations("match/play/x.cpp", "#include \"bridge/lines/line_codec.hpp\"\n").size() == 1);
  CHECK(violations("match/play/x.cpp", "#include \"replays/header/header.hpp\"\n").size() == 1);
  const std::string capture = "experiments/papers/capture/x.cpp";
  CHECK(violations(capture,
                   "#include \"fulbito/report.hpp\"\n#include \"experiments/papers/capture/hall.hpp\"\n")
            .empty());
  CHECK(violations(capture, "#include \"experiments/trials/crowd.hpp\"\n").size() == 1);
  CHECK(violations(capture, vec2).size() == 1);
  CHECK(violations("tournament/plan/x.cpp", "#include \"tournament/runner/runner.hpp\"\n").size() == 1);
}

}  // namespace fulbito::test
