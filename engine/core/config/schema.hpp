#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "engine/core/config/toml_reader.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/detail/vec2.hpp"

/// The keys of configuration tables as data: one list per struct drives reading, range checks, errors for
/// unknown keys, and printing.
namespace fulbito {

/// A label that may become part of a file name: no slashes, no leading dot.
struct Label {
  std::string* text;
};
/// An angle [rad]. Files may give it as `key` in radians or as `key_deg` in degrees; limits are in degrees.
struct Angle {
  double* radians;
};
/// An angle that is wrapped into [-pi, pi) when read.
struct Heading {
  double* radians;
};
/// A heading that may be absent.
struct OptionalHeading {
  std::optional<double>* radians;
};
/// An enum whose values are 0, 1, 2 ... in the order of `names`.
struct Choice {
  std::vector<std::string> names;
  std::function<int()> get;
  std::function<void(int)> set;
};

template <typename E>
Choice choice(E& value, std::vector<std::string> names) {
  return {std::move(names), [&value] { return static_cast<int>(value); },
          [&value](int index) { value = static_cast<E>(index); }};
}

/// One key of a table, bound to a variable.
struct SchemaKey {
  std::string key;
  std::variant<double*, int*, bool*, std::string*, Label, Vec2*, std::vector<Vec2>*, Angle, Heading,
               OptionalHeading, Choice>
      target;
  double minimum = 0.0;  ///< limits of numbers, of both coordinates of points, of the length of strings
  double maximum = 0.0;
  std::string unit;
  std::string doc;
  bool required = false;
};

/// The keys of one table, in the order in which they are printed. Valid while the bound object lives.
using Schema = std::vector<SchemaKey>;

/// A problem with one value of a configuration: `table[index].key text`.
struct Flaw {
  std::string table;
  int index = -1;   ///< in an array of tables, from 0; -1 for a plain table
  std::string key;  ///< empty: the table as a whole
  std::string text;

  /// "obstacle[2].radius = -1 is outside 0.001 ... 5 m"
  std::string message() const;
};

/// The text of a flaw, which follows the key: "= -1 is outside 0.001 ... 50 kg". Empty: no flaw.
using FlawText = std::optional<std::string>;
/// NaN is outside every range.
FlawText checkNumber(double value, double minimum, double maximum, const std::string& unit);
/// Checks the value that the key is bound to.
FlawText checkValue(const SchemaKey& key);
/// Whether files may also give the key in degrees.
bool isAngle(const SchemaKey& key);

/// The first value that is outside its limits.
std::optional<Flaw> rangeFlaw(const Schema& schema, const std::string& table, int index = -1);

/// Success, or the flaw as a kBadInput error.
Result<void> asResult(const std::optional<Flaw>& flaw);

/// The place of a table in a file, for errors.
struct TablePlace {
  std::string origin;  ///< file name
  std::string table;
  int index = -1;  ///< see Flaw
  int line = 1;    ///< line of the table's heading, from 1
};

/// Sets the bound values from `table`. Missing keys leave their values unchanged.
/// Errors: kBadInput as `origin:line: table.key ...` for unknown and missing keys, wrong types and values
/// outside their limits.
Result<void> readTable(const TomlTable& table, const TablePlace& place, const Schema& schema);

/// The value as TOML, empty for an absent one. Reading it back gives the same bits.
std::string valueText(const SchemaKey& key);
/// One `key = value  # unit, doc` line per value; without `comments` only `key = value`.
std::string tableText(const Schema& schema, bool comments);

}  // namespace fulbito
