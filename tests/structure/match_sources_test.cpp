#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/structure/public_headers.hpp"
#include "tests/structure/text_of.hpp"
#include "tests/support/catch.hpp"

// tournament/identity/sources.txt says which sources determine a match. A source that it forgets would let a
// cache of results outlive a change of play.
namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

const fs::path kRoot = FULBITO_SOURCE_DIR;
const std::set<std::string> kTeamGroups{"simple", "classic", "libero", "sparring"};
constexpr std::string_view kTeamFolder = "strategies/teams/";

/// Groups by path, as the list has them.
using Groups = std::map<std::string, std::string>;

Groups groupsIn(const std::string& text) {
  Groups groups;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t space = line.find(' ');
    if (!line.starts_with('#') && space != std::string::npos)
      groups[line.substr(space + 1)] = line.substr(0, space);
  }
  return groups;
}

/// The group of a file; empty if no entry holds it.
std::string groupOf(const Groups& groups, const std::string& file) {
  for (fs::path path = file; !path.empty(); path = path.parent_path()) {
    if (const auto at = groups.find(path.string()); at != groups.end()) return at->second;
  }
  return {};
}

bool isSource(const fs::path& file) {
  static const std::set<std::string> kEndings{".cpp", ".hpp", ".h", ".py"};
  return kEndings.count(file.extension().string()) == 1;
}

/// The sources below the folders that a match may link from, from the root.
std::vector<std::string> linkedSources() {
  std::vector<std::string> files;
  for (const char* top : {"engine", "navigation", "strategies", "referee", "match", "bridge", "sdk",
                          "apps/team_host", "tournament/book"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kRoot / top)) {
      if (isSource(entry.path())) files.push_back(entry.path().lexically_relative(kRoot).generic_string());
    }
  }
  return files;
}

/// Whether a file of group `from` may include one of group `to` without losing what determines a match.
bool covers(const std::string& from, const std::string& to) {
  return to == "engine" || from == to || from == "none";
}

/// The project's files that a source includes, from the root.
std::vector<std::string> includedBy(const std::string& text) {
  static const std::regex include(R"re(#\s*include\s*"([^"]+)")re");
  std::vector<std::string> files;
  for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it) {
    const std::string target = (*it)[1];
    for (const std::string& file : {target, std::string(kPublicFolder) + target}) {
      if (fs::is_regular_file(kRoot / file)) files.push_back(file);
    }
  }
  return files;
}

/// What is wrong with the list for one file.
std::vector<std::string> flawsOf(const Groups& groups, const std::string& file, const std::string& text) {
  const std::string group = groupOf(groups, file);
  if (group.empty()) return {file + " has no group"};
  std::vector<std::string> flaws;
  for (const std::string& target : includedBy(text)) {
    if (covers(group, groupOf(groups, target))) continue;
    flaws.push_back(file + " (" + group + ") includes " + target + " (" + groupOf(groups, target) + ")");
  }
  return flaws;
}

Groups theGroups() { return groupsIn(textOf(kRoot / "tournament/identity/sources.txt")); }

}  // namespace

TEST_CASE("every source that a match may link has a group, and so has what it includes", "[unit]") {
  const Groups groups = theGroups();
  const auto files = linkedSources();
  CHECK(files.size() > 400);
  for (const std::string& file : files) {
    for (const std::string& flaw : flawsOf(groups, file, textOf(kRoot / file))) FAIL_CHECK(flaw);
  }
}

TEST_CASE("a public header has the group of its folder", "[unit]") {
  const Groups groups = theGroups();
  for (const PublicHeader& header : publicHeaders()) {
    INFO(header.name);
    const std::string group = groupOf(groups, std::string(kPublicFolder) + std::string(header.name));
    const std::string owner = groupOf(groups, std::string(header.folder) + "/x.hpp");
    CHECK(group == (owner.empty() ? "none" : owner));
  }
}

TEST_CASE("each folder of built-in teams has a group of its own", "[unit]") {
  const Groups groups = theGroups();
  for (const auto& entry : fs::directory_iterator(kRoot / kTeamFolder)) {
    if (!entry.is_directory()) continue;
    const std::string name = entry.path().filename().string();
    INFO(name);
    CHECK(kTeamGroups.count(name) == 1);
    CHECK(groupOf(groups, std::string(kTeamFolder) + name + "/x.cpp") == name);
  }
}

TEST_CASE("each entry of the list of sources exists", "[unit]") {
  const Groups groups = theGroups();
  CHECK(groups.size() > 30);
  for (const auto& [path, group] : groups) {
    INFO(path);
    CHECK(fs::exists(kRoot / path));
    CHECK((kTeamGroups.count(group) == 1 || group == "engine" || group == "outside" || group == "none"));
  }
}

TEST_CASE("what the list forgets is found", "[unit]") {
  const Groups groups =
      groupsIn("# a note\nengine match\nnone match/report\nsimple strategies/teams/simple\n");
  CHECK(flawsOf(groups, "match/play/match.cpp", "").empty());
  CHECK(flawsOf(groups, "engine/new/thing.cpp", "").size() == 1);
  const std::string report = "#include \"match/report/match_json.hpp\"\n";
  CHECK(flawsOf(groups, "match/play/match.cpp", report).size() == 1);
  CHECK(flawsOf(groups, "match/report/summary.cpp", report).empty());
  CHECK(flawsOf(groups, "strategies/teams/simple/idle.cpp", report).size() == 1);
}

}  // namespace fulbito::test
