#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

namespace {

namespace fs = std::filesystem;

/// Who may include whom: each folder may use itself, the folders named here and what those may use is not
/// implied.
const std::map<std::string, std::set<std::string>> kArrows = {
    {"engine/core", {}},
    {"engine/sim", {"engine/core"}},
    {"navigation", {"engine/core"}},
    {"strategies", {"engine/core", "navigation"}},
    {"referee", {"engine/core"}},
    {"replays", {"engine/core"}},
    {"match", {"engine/core", "engine/sim", "navigation", "strategies", "referee", "replays"}},
    {"replays/render", {"engine/core", "replays"}},
    {"apps/view", {"engine/core", "engine/sim", "referee", "match", "replays", "replays/render"}},
    {"replays/export", {"engine/core", "replays", "replays/render"}},
    {"replays/html", {"engine/core", "replays"}},
    {"experiments",
     {"engine/core", "engine/sim", "navigation", "referee", "replays", "replays/html", "replays/render"}},
    {"bench", {"engine/core", "engine/sim"}},
    {"bench/surveys", {"engine/core", "navigation", "tests/support"}},
    {"tests/support", {"engine/core", "engine/sim", "navigation", "replays", "replays/render"}},
    {"apps",
     {"engine/core", "engine/sim", "navigation", "strategies", "referee", "replays", "match", "replays/html",
      "replays/render", "replays/export", "apps/view", "experiments", "bench"}},
};

/// Third-party headers that each folder may use, in sources only; public headers may use `tl/expected.hpp`
/// and Eigen alone.
const std::map<std::string, std::set<std::string>> kLibraries = {
    {"engine/core", {"fmt", "tl", "toml++", "Random123", "xxhash.h"}},
    {"engine/sim", {"box2d", "fmt"}},
    {"navigation", {"fmt"}},
    {"strategies", {"fmt"}},
    {"referee", {"fmt"}},
    {"replays", {"fmt", "nlohmann", "zstd.h", "xxhash.h"}},
    {"match", {"fmt", "nlohmann"}},
    {"replays/render",
     {"SDL.h", "SDL2", "SDL_ttf.h", "SDL2_gfxPrimitives.h", "png.h", "libdeflate.h", "fmt"}},
    {"apps/view", {"fmt", "SDL.h"}},
    {"replays/export", {"fmt", "nlohmann", "cgif.h"}},
    {"replays/html", {"fmt", "nlohmann", "libdeflate.h"}},
    {"experiments", {"fmt", "nlohmann"}},
    {"bench", {"box2d", "fmt"}},
    {"bench/surveys", {"fmt"}},
    {"tests/support", {"fmt", "nlohmann"}},
    {"apps", {"fmt", "nlohmann", "CLI"}},
};

const std::set<std::string> kKnownLibraries = {
    "fmt",    "tl",           "toml++", "Random123", "xxhash.h",
    "box2d",  "SDL.h",        "SDL2",   "SDL_ttf.h", "SDL2_gfxPrimitives.h",
    "png.h",  "nlohmann",     "CLI",    "Eigen",     "zstd.h",
    "zlib.h", "libdeflate.h", "cgif.h"};

std::string folderOf(const std::string& path) {
  std::string best;
  for (const auto& [folder, unused] : kArrows) {
    if (path.starts_with(folder + "/") && folder.size() > best.size()) best = folder;
  }
  return best;
}

std::vector<std::string> violations(const std::string& path, const std::string& text) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
  const std::string folder = folderOf(path);
  const bool header = path.ends_with(".hpp");
  // A header that is not installed counts as a source.
  const bool is_private = text.starts_with("// Private header of ");
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (!std::regex_search(line, match, include)) continue;
    const std::string target = match[2];
    if (match[1] == "\"") {
      const std::string other = folderOf(target);
      if (other.empty() || (other != folder && kArrows.at(folder).count(other) == 0))
        found.push_back(path + " -> " + target);
      continue;
    }
    const std::string library = target.substr(0, target.find('/'));
    if (kKnownLibraries.count(library) == 0) continue;
    const bool public_ok = library == "tl" || library == "Eigen";
    if (header && !is_private && !public_ok && !path.starts_with("tests/"))
      found.push_back(path + " (a public header) -> " + target);
    if (!public_ok && kLibraries.at(folder).count(library) == 0) found.push_back(path + " -> " + target);
  }
  return found;
}

}  // namespace

TEST_CASE("includes follow the arrows of the architecture", "[unit]") {
  std::vector<std::string> found;
  int files = 0;
  for (const auto& [folder, unused] : kArrows) {
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(FULBITO_SOURCE_DIR) / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".hpp" && extension != ".cpp") continue;
      const std::string path = fs::relative(entry.path(), FULBITO_SOURCE_DIR);
      if (folderOf(path) != folder) continue;
      std::ifstream in(entry.path());
      for (const std::string& v : violations(path, {std::istreambuf_iterator<char>(in), {}}))
        found.push_back(v);
      ++files;
    }
  }
  CHECK(files > 60);
  for (const std::string& v : found) FAIL_CHECK(v);
}

TEST_CASE("installed headers include installed headers only", "[unit]") {
  static const std::regex include("#include \"([^\"]+)\"");
  const fs::path root = FULBITO_SOURCE_DIR;
  const auto textOf = [](const fs::path& path) {
    std::ifstream in(path);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  int headers = 0;
  for (const auto& [folder, unused] : kArrows) {
    for (const auto& entry : fs::directory_iterator(root / folder)) {
      if (entry.path().extension() != ".hpp") continue;
      const std::string text = textOf(entry.path());
      if (text.starts_with("// Private header of ")) continue;
      ++headers;
      for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
        INFO(entry.path() << " -> " << (*it)[1]);
        CHECK_FALSE(textOf(root / (*it)[1].str()).starts_with("// Private header of "));
      }
    }
  }
  CHECK(headers > 30);
}

TEST_CASE("the walk finds a wrong arrow", "[unit]") {
  CHECK(violations("engine/core/x.cpp", "#include \"engine/sim/world.hpp\"\n").size() == 1);
  CHECK(violations("referee/x.cpp", "#include \"navigation/scene.hpp\"\n").size() == 1);
  CHECK(violations("referee/x.cpp", "#include <box2d/box2d.h>\n").size() == 1);
  CHECK(violations("engine/sim/x.hpp", "#include <box2d/box2d.h>\n").size() == 1);
  CHECK(violations("engine/sim/x.cpp", "#include <box2d/box2d.h>\n#include <vector>\n").empty());
  CHECK(violations("navigation/x.hpp", "#include \"engine/core/vec2.hpp\"\n").empty());
}
