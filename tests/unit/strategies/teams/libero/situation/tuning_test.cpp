#include "strategies/teams/libero/situation/tuning.hpp"

#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "fulbito/strategy.hpp"
#include "tests/support/catch.hpp"

// The tuned numbers of libero are few, documented, and in one place.
namespace fulbito {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMost = 40;  // tuned numbers that a reader can keep apart

const fs::path kTeam = FULBITO_SOURCE_DIR "/strategies/teams/libero";

/// Files whose numbers are not yet derived. The list only shrinks.
const std::set<std::string> kNotYet{};

std::vector<std::string> linesOf(const fs::path& path) {
  std::ifstream in(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// The parameters in the table of docs/libero.md, as its rows without the first and the last bar.
std::vector<std::string> rowsOfDocs() {
  std::vector<std::string> rows;
  bool here = false;
  for (const std::string& line : linesOf(FULBITO_SOURCE_DIR "/docs/libero.md")) {
    if (line.starts_with("## ")) here = line == "## Tuned numbers";
    if (here && line.starts_with("| `")) rows.push_back(line);
  }
  return rows;
}

std::string rowOf(const ParameterSpec& spec) {
  static const std::regex parts("(.*); larger: (.*); smaller: (.*)");
  std::smatch part;
  REQUIRE(std::regex_match(spec.doc, part, parts));
  const std::string unit = spec.unit.empty() ? "" : " " + spec.unit;
  return fmt::format("| `{}` | {}{} | {} … {} | {} | {} | {} |", spec.name, spec.default_value, unit,
                     spec.minimum, spec.maximum, part[1].str(), part[2].str(), part[3].str());
}

/// Whether the line is the constant of a rule or of arithmetic: its comment says which.
bool isSourced(const std::string& line) {
  static const std::regex sourced(R"(constexpr double k\w+ = .*//.*(\blaw \d|\brounding\b|\bresolution\b))");
  return std::regex_search(line, sourced);
}

/// The numbers with a fraction or an exponent in a line of code, without those that tune nothing.
std::vector<std::string> numbersIn(std::string line) {
  static const std::regex text(R"("[^"]*")"), comment("//.*"), number(R"(\b\d+\.\d*(?:e-?\d+)?|\b\d+e-?\d+)");
  static const std::set<std::string> plain{"0.0", "0.5", "1.0", "2.0", "1e9", "1e-9"};
  line = std::regex_replace(std::regex_replace(line, text, ""), comment, "");
  std::vector<std::string> found;
  for (std::sregex_iterator it(line.begin(), line.end(), number), end; it != end; ++it) {
    if (!plain.contains(it->str())) found.push_back(it->str());
  }
  return found;
}

}  // namespace

TEST_CASE("libero has at most 40 tuned numbers, each with what it trades", "[unit]") {
  const auto parameters = libero::tuningParameters();
  CHECK(parameters.size() <= kMost);
  CHECK(sizeof(libero::Tuning) == parameters.size() * sizeof(double));
  std::set<std::string> names;
  for (const auto& parameter : parameters) {
    const ParameterSpec& spec = parameter.spec;
    CAPTURE(spec.name);
    CHECK(names.insert(spec.name).second);
    CHECK(spec.minimum <= spec.default_value);
    CHECK(spec.default_value <= spec.maximum);
    CHECK(parseTeam(fmt::format("libero:{}={}", spec.name, spec.minimum)));
    CHECK_FALSE(parseTeam(fmt::format("libero:{}={}", spec.name, spec.maximum + 1.0)));
  }
}

TEST_CASE("The table of libero's tuned numbers in docs/libero.md is that of the program", "[unit]") {
  std::vector<std::string> rows;
  for (const auto& parameter : libero::tuningParameters()) rows.push_back(rowOf(parameter.spec));
  CHECK(rows == rowsOfDocs());
}

TEST_CASE("libero's sources have no tuned numbers of their own", "[unit]") {
  for (const auto& entry : fs::recursive_directory_iterator(kTeam)) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".cpp" && extension != ".hpp") continue;
    const std::string file = fs::relative(entry.path(), kTeam).generic_string();
    bool clean = true;
    for (const std::string& line : linesOf(entry.path())) {
      const bool named = line.find("constexpr double") != std::string::npos;
      if (isSourced(line) || (!named && numbersIn(line).empty())) continue;
      clean = false;
      if (kNotYet.contains(file)) continue;
      UNSCOPED_INFO(file + ": " + line);
      CHECK(line.empty());
    }
    // A file that has become clean leaves the list.
    if (kNotYet.contains(file)) {
      UNSCOPED_INFO(file);
      CHECK_FALSE(clean);
    }
  }
}

}  // namespace fulbito
