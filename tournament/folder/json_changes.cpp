#include "tournament/folder/json_changes.hpp"

#include <algorithm>
#include <cstddef>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace fulbito {
namespace {

using Json = nlohmann::ordered_json;

/// The `key = value` lines of a TOML text as pairs; each key begins with the name of its table.
std::map<std::string, std::string> keysOfToml(const std::string& text) {
  std::map<std::string, std::string> keys;
  std::string table;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.starts_with('[')) table = line.substr(0, line.find(']') + 1) + " ";
    const std::size_t equals = line.find(" = ");
    if (equals == std::string::npos || line.starts_with('#')) continue;
    const std::size_t comment = line.find("  #");
    keys[table + line.substr(0, equals)] =
        line.substr(equals + 3, std::min(comment, line.size()) - equals - 3);
  }
  return keys;
}

/// Adds all values of a JSON value as texts by path. A TOML text inside it is split by its keys.
void flatten(const Json& json, const std::string& path, std::map<std::string, std::string>& values) {
  if (json.is_structured() && !json.empty()) {
    std::size_t i = 0;
    for (const auto& [key, value] : json.items()) {
      const std::string name = json.is_array() ? fmt::format("{}", ++i) : key;
      flatten(value, path.empty() ? name : fmt::format("{}.{}", path, name), values);
    }
    return;
  }
  if (json.is_string() && json.get_ref<const std::string&>().find('\n') != std::string::npos) {
    for (const auto& [key, value] : keysOfToml(json.get<std::string>()))
      values[fmt::format("{} {}", path, key)] = value;
    return;
  }
  values[path] = json.is_string() ? json.get<std::string>() : json.dump();
}

}  // namespace

std::vector<std::string> changesOf(const Json& before, const Json& after) {
  std::map<std::string, std::string> old_values, new_values;
  flatten(before, "", old_values);
  flatten(after, "", new_values);
  std::vector<std::string> changes;
  for (const auto& [key, value] : old_values) {
    const auto now = new_values.find(key);
    if (now == new_values.end()) {
      changes.push_back(fmt::format("{}: {} -> none", key, value));
    } else if (now->second != value) {
      changes.push_back(fmt::format("{}: {} -> {}", key, value, now->second));
    }
  }
  for (const auto& [key, value] : new_values) {
    if (!old_values.contains(key)) changes.push_back(fmt::format("{}: none -> {}", key, value));
  }
  return changes;
}

}  // namespace fulbito
