#include "referee/rules/rules.hpp"

#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "engine/core/config/config_document.hpp"
#include "engine/core/config/presets.hpp"
#include "engine/core/config/suggest.hpp"
#include "engine/core/system/text_file.hpp"
#include "referee/rules/rules_schema.hpp"

namespace fulbito {

/// The profiles that are part of the library; written by the build.
std::span<const EmbeddedFile> embeddedRules();

namespace {

struct RulesFile {
  ConfigDocument document;
  Rules rules;
};

Result<RulesFile> readRules(std::string_view text, const std::string& origin) {
  Rules rules;
  const std::vector<RulesTable> tables = tablesOf(rules);
  std::vector<std::string> names;
  names.reserve(tables.size());
  for (const RulesTable& table : tables) names.push_back(table.name);
  auto document = ConfigDocument::parse(text, origin, names);
  if (!document) return tl::unexpected<Error>(document.error());
  rules.name = document->fallbackName();
  for (const RulesTable& table : tables) {
    if (auto read = document->read(table.name, table.schema, table.name == "rules"); !read) {
      return tl::unexpected<Error>(read.error());
    }
  }
  if (const auto flaw = findFlaw(rules)) return document->locate(*flaw);
  return RulesFile{std::move(*document), rules};
}

/// The comment that a profile begins with.
std::string headOf(std::string_view text) {
  std::size_t end = 0;
  while (end < text.size() && text[end] == '#') end = text.find('\n', end) + 1;
  return std::string(text.substr(0, end));
}

/// The field that the profile names must be there; a relative path counts from the profile's folder.
Result<Rules> withField(RulesFile file, const std::string& path) {
  std::string& field = file.rules.field;
  const std::size_t slash = path.rfind('/');
  if (isFileName(field) && !field.starts_with('/') && slash != std::string::npos) {
    field = path.substr(0, slash + 1) + field;
  }
  const auto loaded = loadField(field);
  if (loaded) return std::move(file.rules);
  Error error =
      file.document.locate({"rules", -1, "field", "cannot be used: " + loaded.error().message}).value();
  if (loaded.error().code == ErrorCode::kIo) error.code = ErrorCode::kIo;
  return tl::unexpected<Error>(std::move(error));
}

}  // namespace

Result<Rules> parseRules(std::string_view text, const std::string& origin) {
  auto file = readRules(text, origin);
  if (!file) return tl::unexpected<Error>(file.error());
  return std::move(file->rules);
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
  auto file = readRules(*text, name_or_file);
  if (!file) return tl::unexpected<Error>(file.error());
  return withField(std::move(*file), name_or_file);
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
    if (file.name != name) continue;
    const auto rules = parseRules(file.text, fmt::format("preset rules/{}", name));
    if (!rules) return tl::unexpected<Error>(rules.error());
    return headOf(file.text) + "\n" + toToml(*rules);
  }
  const std::vector<std::string> names = rulesPresetNames();
  return fail(ErrorCode::kUsage,
              fmt::format("'{}' is neither a file nor one of the presets of rules: {}.{}", printable(name),
                          fmt::join(names, ", "), suggestion(name, names)));
}

}  // namespace fulbito
