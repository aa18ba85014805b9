#include <iterator>
#include <regex>
#include <set>
#include <sstream>

#include "tests/cli/sandbox.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito::test;

namespace {

constexpr std::size_t kWidest = 120;        // columns of a printed line
constexpr std::size_t kDescriptionAt = 36;  // column at which descriptions begin
constexpr std::ptrdiff_t kMostWords = 25;   // of a description
constexpr std::size_t kShortestText = 8;    // characters of a description that says anything

struct HelpText {
  std::string command;  ///< "replay cut"; empty: the program
  std::vector<std::string> lines;
};

/// An option, argument or subcommand as the help prints it.
struct HelpEntry {
  std::string name;
  std::string description;
};

std::vector<std::string> linesOf(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == std::string::npos ? "" : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

bool isHeading(const std::string& line) {
  return !line.empty() && line.front() != ' ' && line.back() == ':' && !line.starts_with("Example");
}

/// The entries of all sections of a help text, or only of the section `heading`. A name that is too long for
/// its column has its description on the next line.
std::vector<HelpEntry> entriesOf(const HelpText& help, const std::string& heading = {}) {
  std::vector<HelpEntry> entries;
  bool inside = false;
  for (const std::string& line : help.lines) {
    if (isHeading(line)) {
      inside = heading.empty() || line == heading;
    } else if (line.empty() || line.front() != ' ') {
      inside = false;
    } else if (inside) {
      const bool continued = line.find_first_not_of(' ') >= kDescriptionAt;
      const bool described = line.size() > kDescriptionAt && line[kDescriptionAt - 1] == ' ';
      if (!continued) entries.push_back({trimmed(described ? line.substr(0, kDescriptionAt) : line), {}});
      if (entries.empty() || !described) continue;
      std::string& text = entries.back().description;
      text += (text.empty() ? "" : " ") + trimmed(line.substr(kDescriptionAt));
    }
  }
  return entries;
}

/// The help of a command and of all its subcommands.
void collectHelp(const Sandbox& box, const std::string& command, std::vector<HelpText>& all) {
  const Output output = box.run(command + " --help");
  INFO(command);
  REQUIRE(output.code == 0);
  const HelpText help{command, linesOf(output.out)};
  all.push_back(help);
  for (const HelpEntry& part : entriesOf(help, "Subcommands:")) {
    collectHelp(box, command + (command.empty() ? "" : " ") + part.name, all);
  }
}

}  // namespace

TEST_CASE("the help of every command is complete, brief and in plain words", "[cli]") {
  const Sandbox box;
  std::vector<HelpText> all;
  collectHelp(box, "", all);
  // Rates take "per"; a condition on another option is "with --record: ...".
  const std::regex banned(
      "\\b(shall|anew|beside|nobody|somebody|whoever|whither)\\b"
      "|\\b(times|lines?|frames|objects?|ticks|one|two) an? "
      "(second|tick|line|sample|event|pair|match|film)\\b"
      "|\\bof --[a-z]",
      std::regex::icase);
  std::set<std::string> found;
  for (const HelpText& help : all) {
    for (const HelpEntry& entry : entriesOf(help)) {
      INFO(help.command << ": " << entry.name << ": " << entry.description);
      found.insert(help.command + " " + entry.name.substr(0, entry.name.find_first_of(" ,")));
      CHECK(entry.description.size() >= kShortestText);
      std::istringstream words(entry.description);
      CHECK(std::distance(std::istream_iterator<std::string>(words), {}) <= kMostWords);
    }
    std::string text;
    for (const std::string& line : help.lines) {
      INFO(help.command << ": " << line);
      CHECK(line.size() <= kWidest);
      CHECK_FALSE(std::regex_search(line, banned));
      text += line + "\n";
    }
    INFO(help.command);
    const bool group = contains(text, "Subcommands:");
    CHECK((group || contains(text, "Example")));
    CHECK((group || contains(text, "fulbito " + help.command)));
  }
  // The walk is one: it found commands of groups, options and arguments.
  for (const char* entry : {" match", "match --record", "match blue", "replay export --contact-sheet",
                            "rules compare --list", "replay verify --jobs"}) {
    INFO(entry);
    CHECK(found.count(entry) == 1);
  }
}
