#include "referee/rules/rules.hpp"

#include <array>
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

/// Keys of [fouls] that are no more. Recordings hold whole profiles, so those of earlier versions have them.
using RetiredKeys = std::array<double, 3>;

void append(Schema& schema, RetiredKeys& values) {
  schema.push_back({"hidden_share", &values[0], 0, 1, "", ""});
  schema.push_back({"hidden_seconds", &values[1], 0, 600, "s", ""});
  schema.push_back({"pinned_gap", &values[2], 0, 1, "m", ""});
}

/// `recorded`: the text may be of an earlier version.
Result<RulesFile> readRules(std::string_view text, const std::string& origin, bool recorded) {
  Rules rules;
  RetiredKeys retired{};
  const std::vector<RulesTable> tables = tablesOf(rules);
  std::vector<std::string> names;
  names.reserve(tables.size());
  for (const RulesTable& table : tables) names.push_back(table.name);
  auto document = ConfigDocument::parse(text, origin, names);
  if (!document) return tl::unexpected<Error>(document.error());
  rules.name = document->fallbackName();
  for (const RulesTable& table : tables) {
    Schema schema = table.schema;
    if (recorded && table.name == "fouls") append(schema, retired);
    if (auto read = document->read(table.name, schema, table.name == "rules"); !read) {
      return tl::unexpected<Error>(read.error());
    }
  }
  if (const auto flaw = findFlaw(rules)) return document->locate(*flaw);
  return RulesFile{std::move(*document), rules};
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
  auto file = readRules(text, origin, true);
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
  auto file = readRules(*text, name_or_file, false);
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
    if (file.name == name) return std::string(file.text);
  }
  const std::vector<std::string> names = rulesPresetNames();
  return fail(ErrorCode::kUsage,
              fmt::format("'{}' is neither a file nor one of the presets of rules: {}.{}", printable(name),
                          fmt::join(names, ", "), suggestion(name, names)));
}

}  // namespace fulbito
