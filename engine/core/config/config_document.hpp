#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/core/config/schema.hpp"
#include "engine/core/config/toml_reader.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// A parsed configuration file that knows the line of each value.
/// All errors are kBadInput in the form `file:line: table.key problem`.
class ConfigDocument {
 public:
  /// `tables` are the allowed top-level tables; any other is an error.
  static Result<ConfigDocument> parse(std::string_view text, const std::string& origin,
                                      std::span<const std::string> tables);

  /// Reads one table. If it is missing: an error if `required`, otherwise no effect.
  Result<void> read(const std::string& table, const Schema& schema, bool required) const;

  /// Whether the table is there.
  bool has(const std::string& table) const { return root_.find(table) != nullptr; }
  /// The size of an array of tables; 0 if it is missing. Errors: it is not an array of tables.
  Result<int> count(const std::string& table) const;
  /// Reads one element of an array of tables, `index` below `count`.
  Result<void> readElement(const std::string& table, int index, const Schema& schema) const;
  /// Whether the element has the key.
  bool elementHas(const std::string& table, int index, std::string_view key) const;

  /// The flaw as an error with the file and the line of its key, or of its table if the key is missing.
  tl::unexpected<Error> locate(const Flaw& flaw) const;

  /// The default for a missing `name` key: the file's name without folder and extension.
  std::string fallbackName() const;

 private:
  const TomlTable& element(const std::string& table, int index) const;
  int lineOf(const Flaw& flaw) const;

  std::string origin_;
  TomlTable root_;
};

}  // namespace fulbito
