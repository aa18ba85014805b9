#include "referee/rules.hpp"

#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "engine/core/config_document.hpp"
#include "engine/core/presets.hpp"
#include "engine/core/suggest.hpp"
#include "engine/core/text_file.hpp"
#include "referee/rules_schema.hpp"

namespace fulbito {

/// The profiles that are part of the library; written by the build.
std::span<const EmbeddedFile> embeddedRules();

Result<Rules> parseRules(std::string_view text, const std::string& origin) {
  Rules rules;
  const std::vector<RulesTable> tables = tablesOf(rules);
  std::vector<std::string> names;
  for (const RulesTable& table : tables) names.push_back(table.name);
  const auto document = ConfigDocument::parse(text, origin, names);
  if (!document) return tl::unexpected<Error>(document.error());
  rules.name = document->fallbackName();
  for (const RulesTable& table : tables) {
    if (auto read = document->read(table.name, table.schema, table.name == "rules"); !read) {
      return tl::unexpected<Error>(read.error());
    }
  }
  if (const auto flaw = findFlaw(rules)) return document->locate(*flaw);
  return rules;
}

Result<Rules> loadRules(const std::string& name_or_file) {
  const bool named_file = isFileName(name_or_file);
  if (!named_file) {
    for (const EmbeddedFile& file : embeddedRules()) {
      if (file.name == name_or_file) return parseRules(file.text, fmt::format("preset rules/{}", file.name));
    }
  }
  std::error_code ignored;
  if (!named_file && !std::filesystem::exists(name_or_file, ignored)) {
    return tl::unexpected<Error>(rulesPresetText(name_or_file).error());
  }
  const auto text = readTextFile(name_or_file, kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return parseRules(*text, name_or_file);
}

Result<void> validate(const Rules& rules) { return asResult(findFlaw(rules)); }

std::string toToml(const Rules& rules) {
  Rules copy = rules;
  std::string text;
  for (const RulesTable& table : tablesOf(copy)) {
    text += fmt::format("{}# {}\n[{}]\n{}", text.empty() ? "" : "\n", table.doc, table.name,
                        tableText(table.schema, true));
  }
  return text;
}

std::vector<std::string> rulesPresetNames() {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embeddedRules()) names.emplace_back(file.name);
  return names;
}

Result<std::string> rulesPresetText(const std::string& name) {
  for (const EmbeddedFile& file : embeddedRules()) {
    if (file.name == name) return std::string(file.text);
  }
  const std::vector<std::string> names = rulesPresetNames();
  return fail(ErrorCode::kUsage,
              fmt::format("'{}' is neither a file nor one of the presets of rules: {}.{}", printable(name),
                          fmt::join(names, ", "), suggestion(name, names)));
}

}  // namespace fulbito
