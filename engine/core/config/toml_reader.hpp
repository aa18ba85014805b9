#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fulbito/detail/values.hpp"

namespace fulbito {

struct TomlEntry;
struct TomlValue;

/// A table of a TOML document: its entries in the order of the file.
struct TomlTable {
  std::vector<TomlEntry> entries;

  /// The entry with that key, or null.
  const TomlEntry* find(std::string_view key) const;
};

using TomlArray = std::vector<TomlValue>;

/// One value of a TOML document. `std::monostate` stands for a date or time, which no file here uses.
struct TomlValue {
  std::variant<std::monostate, bool, std::int64_t, double, std::string, TomlArray, TomlTable> data;
  int line = 1;  ///< its first line, from 1
};

/// A key and its value.
struct TomlEntry {
  std::string key;
  TomlValue value;
  int line = 1;  ///< line of the key, from 1
};

/// Largest configuration text [bytes].
inline constexpr std::size_t kMaxTomlBytes = std::size_t{1} << 20;

/// Parses TOML 1.0. `origin` stands for the file name in errors.
/// Errors: kBadInput as `origin:line: problem` for text that is not TOML, is larger than `kMaxTomlBytes`
/// or is nested deeper than any configuration.
Result<TomlTable> parseToml(std::string_view text, const std::string& origin);

/// The type of a value in words: "a number", "a table".
std::string_view typeName(const TomlValue& value);

/// `text` for a message: control and non-ASCII bytes as \xNN, truncated after `longest` bytes. Otherwise an
/// untrusted file could send commands to the terminal.
std::string printable(std::string_view text, std::size_t longest = 60);

/// `value` as a TOML float that reads back to the same bits.
std::string tomlNumber(double value);
/// `text` as a TOML basic string.
std::string tomlString(std::string_view text);

}  // namespace fulbito
