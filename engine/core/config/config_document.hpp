// Private header of engine/core: not installed.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/core/base/result.hpp"
#include "engine/core/config/schema.hpp"
#include "engine/core/config/toml_reader.hpp"

namespace fulbito {

/// A parsed configuration file that knows where each of its values stands.
/// All errors are kBadInput and read `file:line: table.key what is wrong`.
class ConfigDocument {
 public:
  /// `tables` are the names that the file may have at its top; any other is an error.
  static Result<ConfigDocument> parse(std::string_view text, const std::string& origin,
                                      std::span<const std::string> tables);

  /// Reads one table; without it, an error when `required` and nothing otherwise.
  Result<void> read(const std::string& table, const Schema& schema, bool required) const;

  /// How many tables an array of tables has: 0 without it. Errors: it is not an array of tables.
  Result<int> count(const std::string& table) const;
  /// Reads one element of an array of tables, `index` below `count`.
  Result<void> readElement(const std::string& table, int index, const Schema& schema) const;
  /// Whether that element has the key.
  bool elementHas(const std::string& table, int index, std::string_view key) const;

  /// The flaw as an error that names the file and the line of its key, or of its table without the key.
  tl::unexpected<Error> locate(const Flaw& flaw) const;

  /// A name for what the file describes when it gives none: the file's own, without folder and ending.
  std::string fallbackName() const;

 private:
  const TomlTable& element(const std::string& table, int index) const;
  int lineOf(const Flaw& flaw) const;

  std::string origin_;
  TomlTable root_;
};

}  // namespace fulbito
