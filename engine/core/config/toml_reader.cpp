#include "engine/core/config/toml_reader.hpp"

#include <algorithm>
#include <optional>

#include <fmt/format.h>

#include "engine/core/base/overloaded.hpp"

// Some invalid files, such as "[ ]", violate the parser's assertions although it then reports them properly.
// The assertions would abort, and clang with NDEBUG would optimise on them.
#undef NDEBUG
#define TOML_ASSERT(condition) static_cast<void>(0)
#define TOML_HEADER_ONLY 1
#define TOML_EXCEPTIONS 0
#include <toml++/toml.h>

namespace fulbito {
namespace {

constexpr int kMaxDepth = 16;
// A dotted key makes one table per dot, and the parser destroys nested tables recursively: 100,000 levels
// overflow the stack. No key spans lines, and the limit per line is half as many dots.
constexpr std::ptrdiff_t kMaxDotsPerLine = 4000;

int lineOf(const toml::source_region& region) { return std::max(1, static_cast<int>(region.begin.line)); }

std::optional<int> lineWithTooManyDots(std::string_view text) {
  int line = 1;
  std::ptrdiff_t dots = 0;
  for (char c : text) {
    if (c == '\n') ++line, dots = 0;
    if (c == '.' && ++dots > kMaxDotsPerLine) return line;
  }
  return std::nullopt;
}

int depthOf(const toml::node& node, int limit) {
  if (limit == 0) return 0;
  int below = 0;
  if (const toml::table* table = node.as_table()) {
    for (const auto& [key, value] : *table) below = std::max(below, depthOf(value, limit - 1));
  } else if (const toml::array* array = node.as_array()) {
    for (const toml::node& element : *array) below = std::max(below, depthOf(element, limit - 1));
  }
  return below + 1;
}

TomlTable convertTable(const toml::table& table);

TomlValue convert(const toml::node& node) {
  TomlValue value;
  value.line = lineOf(node.source());
  if (const auto* table = node.as_table()) {
    value.data = convertTable(*table);
  } else if (const auto* array = node.as_array()) {
    TomlArray elements;
    elements.reserve(array->size());
    for (const toml::node& element : *array) elements.push_back(convert(element));
    value.data = std::move(elements);
  } else if (const auto* flag = node.as_boolean()) {
    value.data = flag->get();
  } else if (const auto* integer = node.as_integer()) {
    value.data = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    value.data = number->get();
  } else if (const auto* text = node.as_string()) {
    value.data = text->get();
  }
  return value;
}

TomlTable convertTable(const toml::table& table) {
  TomlTable result;
  result.entries.reserve(table.size());
  for (const auto& [key, node] : table) {
    result.entries.push_back({std::string(key.str()), convert(node), lineOf(key.source())});
  }
  std::stable_sort(result.entries.begin(), result.entries.end(),
                   [](const TomlEntry& a, const TomlEntry& b) { return a.line < b.line; });
  return result;
}

}  // namespace

const TomlEntry* TomlTable::find(std::string_view key) const {
  const auto found =
      std::find_if(entries.begin(), entries.end(), [key](const TomlEntry& e) { return e.key == key; });
  return found == entries.end() ? nullptr : &*found;
}

Result<TomlTable> parseToml(std::string_view text, const std::string& origin) {
  if (text.size() > kMaxTomlBytes) {
    return fail(ErrorCode::kBadInput,
                fmt::format("{}: larger than the limit of {} bytes", origin, kMaxTomlBytes));
  }
  if (const auto line = lineWithTooManyDots(text)) {
    return fail(ErrorCode::kBadInput,
                fmt::format("{}:{}: more than {} dots on one line", origin, *line, kMaxDotsPerLine));
  }
  const toml::parse_result parsed = toml::parse(text, origin);
  if (!parsed) {
    const toml::parse_error& error = parsed.error();
    return fail(ErrorCode::kBadInput, fmt::format("{}:{}: not valid TOML: {}", origin, lineOf(error.source()),
                                                  printable(error.description(), 200)));
  }
  for (const auto& [key, node] : parsed.table()) {
    if (depthOf(node, kMaxDepth) < kMaxDepth) continue;
    return fail(ErrorCode::kBadInput, fmt::format("{}:{}: '{}' is nested deeper than {} levels", origin,
                                                  lineOf(key.source()), printable(key.str()), kMaxDepth));
  }
  return convertTable(parsed.table());
}

std::string_view typeName(const TomlValue& value) {
  return std::visit(
      Overloaded{[](std::monostate) { return "a date or time"; }, [](bool) { return "a boolean"; },
                 [](std::int64_t) { return "a whole number"; }, [](double) { return "a number"; },
                 [](const std::string&) { return "a string"; }, [](const TomlArray&) { return "an array"; },
                 [](const TomlTable&) { return "a table"; }},
      value.data);
}

std::string printable(std::string_view text, std::size_t longest) {
  std::string result;
  for (char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      result += fmt::format("\\x{:02x}", byte);
    }
  }
  return text.size() > longest ? result + "..." : result;
}

std::string tomlNumber(double value) {
  std::string text = fmt::format("{}", value);
  // Without a decimal point it would be an integer, which has no -0.
  if (text.find_first_not_of("-0123456789") == std::string::npos) text += ".0";
  return text;
}

std::string tomlString(std::string_view text) {
  std::string result = "\"";
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || byte == 0x7f) {
      result += fmt::format("\\u{:04x}", byte);
    } else {
      result += c;
    }
  }
  return result + '"';
}

}  // namespace fulbito
