#include "tests/structure/public_headers.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

// The public interface stays small, whole and explained: what a user reads is here on purpose.
namespace fulbito::test {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostHeaders = 17;  // 14 of the simulator, 3 for the authors of teams
constexpr std::size_t kMostDetails = 33;  // 30, and 3 that join the classes of team.hpp to the C interface
constexpr double kLeastCommented = 0.5;   // of the lines that are not blank
const std::string kDetail = "fulbito/detail/";

fs::path publicRoot() { return fs::path(FULBITO_SOURCE_DIR) / kPublicFolder; }

std::string textOf(const std::string& name) {
  std::ifstream in(publicRoot() / name);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// As in #include.
std::set<std::string> headersThere() {
  std::set<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(publicRoot())) {
    if (entry.is_regular_file()) names.insert(fs::relative(entry.path(), publicRoot()));
  }
  return names;
}

std::vector<std::string> includesOf(const std::string& name) {
  static const std::regex include(R"(#include ([<"][^>"]+)[>"])");
  const std::string text = textOf(name);
  std::vector<std::string> found;
  for (std::sregex_iterator it(text.begin(), text.end(), include), end; it != end; ++it)
    found.push_back((*it)[1]);
  return found;
}

void addNeeded(const std::string& name, std::set<std::string>& needed) {
  if (!needed.insert(name).second) return;
  for (const std::string& target : includesOf(name)) {
    if (target.front() == '"') addNeeded(target.substr(1), needed);
  }
}

}  // namespace

TEST_CASE("the public headers are few, and each belongs to a folder of the sources", "[unit]") {
  std::set<std::string> listed;
  std::size_t details = 0;
  for (const PublicHeader& header : publicHeaders()) {
    listed.insert(std::string(header.name));
    details += header.name.starts_with(kDetail) ? 1 : 0;
    INFO(header.name);
    CHECK(fs::is_directory(fs::path(FULBITO_SOURCE_DIR) / header.folder));
  }
  CHECK(listed == headersThere());
  CHECK(details <= kMostDetails);
  CHECK(listed.size() - details <= kMostHeaders);
  CHECK(listed.size() - details >= 6);
}

TEST_CASE("a public header needs public headers, the standard library and tl::expected only", "[unit]") {
  std::set<std::string> needed;
  for (const std::string& name : headersThere()) {
    if (!name.starts_with(kDetail)) addNeeded(name, needed);
    for (const std::string& target : includesOf(name)) {
      INFO(name << " -> " << target);
      if (target.front() == '"') {
        CHECK(target.starts_with("\"fulbito/"));
      } else {
        CHECK((target.find('/') == std::string::npos || target == "<tl/expected.hpp"));
      }
    }
  }
  INFO("headers under detail that no other needs");
  CHECK(needed == headersThere());
}

TEST_CASE("every second line of the public headers is explained", "[unit]") {
  int lines = 0, commented = 0;
  for (const std::string& name : headersThere()) {
    // The code that joins teams to the C interface and to the line protocol: it is in headers, but nobody's
    // interface.
    if (name.starts_with(kDetail + "lines/") || name.starts_with(kDetail + "library/")) continue;
    std::istringstream text(textOf(name));
    for (std::string line; std::getline(text, line);) {
      if (line.find_first_not_of(' ') == std::string::npos) continue;
      ++lines;
      commented += line.find("//") != std::string::npos ? 1 : 0;
    }
  }
  INFO(commented << " of " << lines << " lines");
  CHECK(lines > 1000);
  CHECK(commented >= kLeastCommented * lines);
}

}  // namespace fulbito::test
