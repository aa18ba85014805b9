#include <fstream>
#include <map>
#include <string>

#include <fmt/format.h>

#include "fulbito/navigation.hpp"
#include "tests/support/catch.hpp"

// The tables in docs/navigators.md list every parameter of every method with its default.
namespace fulbito {
namespace {

using Table = std::map<std::string, std::string>;  // default by name, both as printed

/// The cell with the number `number` in a row `| name | default | ...`.
std::string cellOf(const std::string& row, int number) {
  std::size_t from = 0;
  for (int i = 0; i <= number; ++i) from = row.find('|', from) + 1;
  const std::string cell = row.substr(from, row.find('|', from) - from);
  const std::size_t begin = cell.find_first_not_of(" `"), end = cell.find_last_not_of(" `");
  return begin == std::string::npos ? "" : cell.substr(begin, end - begin + 1);
}

/// The tables of parameters by the heading above them.
std::map<std::string, Table> tablesOfPage() {
  std::ifstream in(FULBITO_SOURCE_DIR "/docs/navigators.md");
  REQUIRE(in);
  std::map<std::string, Table> tables;
  std::string heading;
  bool inside = false;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("## ") || line.starts_with("### ")) heading = line.substr(line.find(' ') + 1);
    if (!line.starts_with("|")) inside = false;
    if (inside && !line.starts_with("|---")) tables[heading][cellOf(line, 0)] = cellOf(line, 1);
    if (line.starts_with("| name | default |")) inside = true;
  }
  return tables;
}

std::string printed(const ParameterSpec& spec) {
  if (spec.type == ParameterSpec::Type::kFlag) return spec.default_value != 0.0 ? "on" : "off";
  if (spec.type == ParameterSpec::Type::kChoice)
    return spec.choices[static_cast<std::size_t>(spec.default_value)];
  return fmt::format("{:.6g}", spec.default_value);
}

}  // namespace

TEST_CASE("the page of navigators names every parameter with its default", "[unit]") {
  std::map<std::string, Table> tables = tablesOfPage();
  // Three fields share the parameters of the goal field. The page states where the default of `goal` differs.
  Table goal_field = tables["Heading fields"];
  goal_field.erase("goal");
  CHECK(goal_field.size() == 4);
  for (const NavigatorInfo& info : navigators()) {
    Table rows = tables[info.name];
    for (const ParameterSpec& spec : info.parameters) {
      CAPTURE(info.name, spec.name);
      if (spec.name == "goal") continue;
      const Table& table = rows.count(spec.name) == 1 ? rows : goal_field;
      REQUIRE(table.count(spec.name) == 1);
      CHECK(table.at(spec.name) == printed(spec));
      rows.erase(spec.name);
    }
    CAPTURE(info.name);
    CHECK(rows.empty());
  }
}

}  // namespace fulbito
