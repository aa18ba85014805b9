#include "engine/core/config/config_document.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "engine/core/config/suggest.hpp"
#include "engine/core/system/error_text.hpp"

namespace fulbito {

Result<ConfigDocument> ConfigDocument::parse(std::string_view text, const std::string& origin,
                                             std::span<const std::string> tables) {
  auto root = parseToml(text, origin);
  if (!root) return tl::unexpected<Error>(root.error());
  for (const TomlEntry& entry : root->entries) {
    if (std::find(tables.begin(), tables.end(), entry.key) != tables.end()) continue;
    std::string hint = suggestion(entry.key, tables);
    if (hint.empty()) hint = fmt::format(" Its tables: {}.", fmt::join(tables, ", "));
    return fail(ErrorCode::kBadInput, fmt::format("{}:{}: '{}' is not a table of this file.{}", origin,
                                                  entry.line, printable(entry.key), hint));
  }
  ConfigDocument document;
  document.origin_ = origin;
  document.root_ = std::move(*root);
  return document;
}

Result<void> ConfigDocument::read(const std::string& table, const Schema& schema, bool required) const {
  const TomlEntry* entry = root_.find(table);
  if (entry == nullptr) {
    if (!required) return {};
    return fail(ErrorCode::kBadInput, fmt::format("{}:1: the table [{}] is missing", origin_, table));
  }
  const auto* content = std::get_if<TomlTable>(&entry->value.data);
  if (content == nullptr) {
    return fail(ErrorCode::kBadInput, fmt::format("{}:{}: {} must be a table [{}], not {}", origin_,
                                                  entry->line, table, table, typeName(entry->value)));
  }
  return readTable(*content, {origin_, table, -1, entry->line}, schema);
}

Result<int> ConfigDocument::count(const std::string& table) const {
  const TomlEntry* entry = root_.find(table);
  if (entry == nullptr) return 0;
  const auto* array = std::get_if<TomlArray>(&entry->value.data);
  const auto is_table = [](const TomlValue& v) { return std::holds_alternative<TomlTable>(v.data); };
  if (array == nullptr || !std::all_of(array->begin(), array->end(), is_table)) {
    return fail(ErrorCode::kBadInput,
                fmt::format("{}:{}: {} must be tables headed [[{}]]", origin_, entry->line, table, table));
  }
  return static_cast<int>(array->size());
}

const TomlTable& ConfigDocument::element(const std::string& table, int index) const {
  const auto& array = std::get<TomlArray>(root_.find(table)->value.data);
  return std::get<TomlTable>(array[static_cast<std::size_t>(index)].data);
}

Result<void> ConfigDocument::readElement(const std::string& table, int index, const Schema& schema) const {
  return readTable(element(table, index), {origin_, table, index, lineOf({table, index, "", ""})}, schema);
}

bool ConfigDocument::elementHas(const std::string& table, int index, std::string_view key) const {
  return element(table, index).find(key) != nullptr;
}

int ConfigDocument::lineOf(const Flaw& flaw) const {
  const TomlEntry* entry = root_.find(flaw.table);
  if (entry == nullptr) return 1;
  const TomlValue* value = &entry->value;
  int line = entry->line;
  if (const auto* array = std::get_if<TomlArray>(&value->data)) {
    if (flaw.index < 0 || flaw.index >= static_cast<int>(array->size())) return line;
    value = &(*array)[static_cast<std::size_t>(flaw.index)];
    line = value->line;
  }
  const auto* table = std::get_if<TomlTable>(&value->data);
  if (table == nullptr) return line;
  for (const std::string& key : {flaw.key, flaw.key + "_deg"}) {
    if (const TomlEntry* found = table->find(key)) return found->line;
  }
  return line;
}

tl::unexpected<Error> ConfigDocument::locate(const Flaw& flaw) const {
  return fail(ErrorCode::kBadInput, fmt::format("{}:{}: {}", origin_, lineOf(flaw), flaw.message()));
}

std::string ConfigDocument::fallbackName() const {
  std::string name = origin_.substr(origin_.find_last_of("/\\") + 1);
  if (name.ends_with(".toml")) name.resize(name.size() - 5);
  std::erase_if(name, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; });
  name.erase(0, name.find_first_not_of('.'));
  if (name.empty()) return "unnamed";
  // A file's name may hold any bytes, but labels may not contain backslashes.
  name = terminalText(name);
  std::replace(name.begin(), name.end(), '\\', '_');
  return std::string(firstBytes(name, 100));
}

}  // namespace fulbito
