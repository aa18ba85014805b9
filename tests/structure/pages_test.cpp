#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/catch.hpp"

// What a program can check of the pages: long lines, and links and pictures that lead nowhere.
namespace fulbito {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongest = 160;  // characters of a line of prose

struct Line {
  std::string text;
  bool code = false;  ///< in a block between ``` or the mark of one
};

using Page = std::vector<Line>;

Page pageOfStream(std::istream& in) {
  Page page;
  bool code = false;
  for (std::string text; std::getline(in, text);) {
    const std::size_t start = std::min(text.find_first_not_of(' '), text.size());
    const bool mark = text.compare(start, 3, "```") == 0;
    page.push_back({text, code || mark});
    if (mark) code = !code;
  }
  return page;
}

Page pageOfText(const std::string& text) {
  std::istringstream in(text);
  return pageOfStream(in);
}

Page pageOf(const fs::path& file) {
  std::ifstream in(file);
  REQUIRE(in);
  return pageOfStream(in);
}

std::size_t charactersOf(const std::string& utf8) {
  return static_cast<std::size_t>(
      std::count_if(utf8.begin(), utf8.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

bool isTable(const std::string& text) {
  const std::size_t start = text.find_first_not_of(' ');
  return start != std::string::npos && text[start] == '|';
}

/// Numbers of the lines of prose that are too long; lines with an address, which nobody can break, are left
/// out.
std::vector<std::size_t> longLines(const Page& page) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < page.size(); ++i) {
    const std::string& text = page[i].text;
    if (page[i].code || isTable(text) || text.find("://") != std::string::npos) continue;
    if (charactersOf(text) > kLongest) numbers.push_back(i + 1);
  }
  return numbers;
}

/// `text` without its code spans.
std::string withoutCode(const std::string& text) {
  std::string rest;
  bool code = false;
  for (const char c : text) {
    if (c == '`') code = !code;
    if (!code) rest += c;
  }
  return rest;
}

/// Targets of links and pictures, `](target)`, but for addresses.
std::vector<std::string> targetsOf(const Page& page) {
  std::vector<std::string> targets;
  for (const Line& line : page) {
    if (line.code) continue;
    const std::string text = withoutCode(line.text);
    for (std::size_t at = text.find("]("); at != std::string::npos; at = text.find("](", at + 1)) {
      const std::string target = text.substr(at + 2, text.find(')', at) - at - 2);
      if (target.find("://") == std::string::npos) targets.push_back(target);
    }
  }
  return targets;
}

/// Sources and scripts that code spans name by their path from the root; `my_...` and words in capitals stand
/// for the reader's own files.
std::vector<std::string> sourcesOf(const Page& page) {
  static const std::regex kPath(
      "`((engine|navigation|strategies|referee|replays|match|trials|experiments|apps|bench|tests|"
      "cmake|scripts|docs)(/[a-z0-9_.-]+)+\\.(cpp|hpp|txt|toml|md|sh|cmake|js|css))`");
  std::vector<std::string> paths;
  for (const Line& line : page) {
    if (line.code) continue;
    for (std::sregex_iterator at(line.text.begin(), line.text.end(), kPath), end; at != end; ++at) {
      if ((*at)[1].str().find("/my_") == std::string::npos) paths.push_back((*at)[1]);
    }
  }
  return paths;
}

/// The anchor that readers of Markdown make of a heading: lower case, spaces as dashes, no other signs.
std::string anchorOf(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == ' ') anchor += '-';
    if (std::isalnum(byte) != 0 || c == '-' || c == '_' || byte >= 0x80) {
      anchor += static_cast<char>(std::tolower(byte));
    }
  }
  return anchor;
}

std::set<std::string> anchorsOf(const Page& page) {
  std::set<std::string> anchors;
  for (const Line& line : page) {
    const std::size_t level = line.text.find_first_not_of('#');
    if (line.code || level == 0 || level == std::string::npos || line.text[level] != ' ') continue;
    anchors.insert(anchorOf(line.text.substr(level + 1)));
  }
  return anchors;
}

/// Whether `target`, as it stands in the page `file`, leads to a file, and its `#anchor` to a heading.
bool leads(const fs::path& file, const std::string& target) {
  const std::size_t hash = target.find('#');
  const std::string path = target.substr(0, hash);
  const fs::path to = path.empty() ? file : file.parent_path() / path;
  if (!fs::exists(to)) return false;
  return hash == std::string::npos || anchorsOf(pageOf(to)).count(target.substr(hash + 1)) == 1;
}

std::vector<fs::path> pages() {
  const fs::path root = FULBITO_SOURCE_DIR;
  std::vector<fs::path> files = {root / "README.md", root / "CONTRIBUTING.md", root / "CHANGELOG.md"};
  for (const char* folder : {"docs", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const bool ours = entry.path().string().find("node_modules") == std::string::npos;
      if (ours && entry.path().extension() == ".md") files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

TEST_CASE("lines of the pages can be read without scrolling", "[unit]") {
  CHECK(pages().size() > 20);
  for (const fs::path& file : pages()) {
    for (const std::size_t number : longLines(pageOf(file))) {
      FAIL_CHECK(file.string() << ":" << number << " has more than " << kLongest << " characters");
    }
  }
}

TEST_CASE("links and pictures of the pages lead somewhere", "[unit]") {
  std::size_t targets = 0;
  for (const fs::path& file : pages()) {
    for (const std::string& target : targetsOf(pageOf(file))) {
      ++targets;
      CAPTURE(file.string(), target);
      CHECK(leads(file, target));
    }
  }
  CHECK(targets > 100);
}

TEST_CASE("sources that the pages name are there", "[unit]") {
  std::size_t sources = 0;
  for (const fs::path& file : pages()) {
    for (const std::string& source : sourcesOf(pageOf(file))) {
      ++sources;
      CAPTURE(file.string(), source);
      CHECK(fs::exists(fs::path(FULBITO_SOURCE_DIR) / source));
    }
  }
  CHECK(sources > 60);
}

TEST_CASE("every page of the docs is named by the README, every picture by a page", "[unit]") {
  const fs::path root = FULBITO_SOURCE_DIR;
  std::set<fs::path> named;
  for (const fs::path& file : pages()) {
    for (const std::string& target : targetsOf(pageOf(file))) {
      const bool picture = target.ends_with(".png") || target.ends_with(".gif");
      const std::string name = file.filename().string();
      if (picture || name == "README.md") named.insert((file.parent_path() / target).lexically_normal());
    }
  }
  for (const auto& entry : fs::recursive_directory_iterator(root / "docs")) {
    if (!entry.is_regular_file() || entry.path().filename() == "README.md") continue;
    CAPTURE(entry.path().string());
    CHECK(named.count(entry.path().lexically_normal()) == 1);
  }
}

TEST_CASE("the checks of pages find what is planted", "[unit]") {
  const std::string wide(kLongest, 'x');
  CHECK(longLines(pageOfText(wide + "\n" + wide + "y\n")) == std::vector<std::size_t>{2});
  CHECK(longLines(pageOfText("| " + wide + " |\n  | " + wide + "\n```\n" + wide + "y\n```\n")).empty());
  std::string umlauts;
  for (std::size_t i = 0; i < kLongest; ++i) umlauts += "ü";
  CHECK(longLines(pageOfText(umlauts + "\n")).empty());

  const Page page =
      pageOfText("# A page, *two* words\n\nsee [a](b#c) and ![d](e.png), `[f](g)`\n```\n[h](i)\n```\n");
  CHECK(targetsOf(page) == std::vector<std::string>{"b#c", "e.png"});
  CHECK(anchorsOf(page) == std::set<std::string>{"a-page-two-words"});
  const Page sources =
      pageOfText("`match/a.cpp`, `match/my_b.cpp`, `match/C/d.hpp`, `e/f.cpp`\n```\n`match/g.cpp`\n```\n");
  CHECK(sourcesOf(sources) == std::vector<std::string>{"match/a.cpp"});
  const fs::path readme = fs::path(FULBITO_SOURCE_DIR) / "README.md";
  CHECK(leads(readme, "docs/rules.md#events"));
  CHECK_FALSE(leads(readme, "docs/rules.md#no-such-heading"));
  CHECK_FALSE(leads(readme, "docs/no-such-page"));
}

}  // namespace fulbito
