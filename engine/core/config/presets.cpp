#include <filesystem>

#include <fmt/format.h>

#include "engine/core/config/config_document.hpp"
#include "engine/core/config/embedded_files.hpp"
#include "engine/core/config/schemas.hpp"
#include "engine/core/config/suggest.hpp"
#include "engine/core/system/text_file.hpp"
#include "fulbito/models.hpp"

namespace fulbito {
namespace {

const EmbeddedFile* findPreset(std::string_view kind, std::string_view name) {
  for (const EmbeddedFile& file : embeddedPresets()) {
    if (file.kind == kind && file.name == name) return &file;
  }
  return nullptr;
}

struct Source {
  std::string text;
  std::string origin;
};

Result<Source> openSource(std::string_view kind, const std::string& name_or_file) {
  const bool named_file = isFileName(name_or_file);
  if (!named_file) {
    if (const EmbeddedFile* preset = findPreset(kind, name_or_file)) {
      return Source{std::string(preset->text), fmt::format("preset {}/{}", kind, name_or_file)};
    }
  }
  std::error_code ignored;
  if (!named_file && !std::filesystem::exists(name_or_file, ignored)) {
    return tl::unexpected<Error>(presetText(kind, name_or_file).error());
  }
  auto text = readTextFile(name_or_file, kMaxTomlBytes);
  if (!text) return tl::unexpected<Error>(text.error());
  return Source{std::move(*text), name_or_file};
}

/// One table that is read into one struct.
template <typename T>
Result<T> parseTable(const std::string& table, std::string_view text, const std::string& origin) {
  const auto document = ConfigDocument::parse(text, origin, std::span(&table, 1));
  if (!document) return tl::unexpected<Error>(document.error());
  T value;
  value.name = document->fallbackName();
  if (auto read = document->read(table, schemaOf(value), true); !read)
    return tl::unexpected<Error>(read.error());
  if (const auto flaw = findFlaw(value)) return document->locate(*flaw);
  return value;
}

/// Parses the text of a preset or file.
template <typename T>
Result<T> loadWith(Result<T> (*parse)(std::string_view, const std::string&), std::string_view kind,
                   const std::string& name_or_file) {
  const auto source = openSource(kind, name_or_file);
  if (!source) return tl::unexpected<Error>(source.error());
  return parse(source->text, source->origin);
}

template <typename T>
std::string tableOf(const char* heading, T value) {
  return fmt::format("[{}]\n{}", heading, tableText(schemaOf(value), true));
}

}  // namespace

bool isFileName(std::string_view name_or_file) {
  return name_or_file.find('/') != std::string_view::npos || name_or_file.ends_with(".toml");
}

Result<RobotPreset> parseRobot(std::string_view text, const std::string& origin) {
  static const std::vector<std::string> kTables{"robot", "ball"};
  const auto document = ConfigDocument::parse(text, origin, kTables);
  if (!document) return tl::unexpected<Error>(document.error());
  RobotPreset preset;
  preset.robot.name = document->fallbackName();
  if (auto read = document->read("robot", schemaOf(preset.robot), true); !read) {
    return tl::unexpected<Error>(read.error());
  }
  if (auto read = document->read("ball", schemaOf(preset.ball), false); !read) {
    return tl::unexpected<Error>(read.error());
  }
  if (const auto flaw = findFlaw(preset.robot)) return document->locate(*flaw);
  if (const auto flaw = findFlaw(preset.ball)) return document->locate(*flaw);
  return preset;
}

Result<PhysicsProfile> parsePhysics(std::string_view text, const std::string& origin) {
  return parseTable<PhysicsProfile>("physics", text, origin);
}

Result<FieldGeometry> parseField(std::string_view text, const std::string& origin) {
  return parseTable<FieldGeometry>("field", text, origin);
}

Result<RobotPreset> loadRobot(const std::string& name_or_file) {
  return loadWith(parseRobot, "robots", name_or_file);
}
Result<PhysicsProfile> loadPhysics(const std::string& name_or_file) {
  return loadWith(parsePhysics, "physics", name_or_file);
}
Result<FieldGeometry> loadField(const std::string& name_or_file) {
  return loadWith(parseField, "fields", name_or_file);
}

std::string toToml(const RobotPreset& preset) {
  return tableOf("robot", preset.robot) + "\n" + tableOf("ball", preset.ball);
}
std::string toToml(const PhysicsProfile& physics) { return tableOf("physics", physics); }
std::string toToml(const FieldGeometry& field) { return tableOf("field", field); }

std::vector<std::string> presetNames(std::string_view kind) {
  std::vector<std::string> names;
  for (const EmbeddedFile& file : embeddedPresets()) {
    if (file.kind == kind) names.emplace_back(file.name);
  }
  return names;
}

Result<std::string> presetText(std::string_view kind, const std::string& name) {
  if (const EmbeddedFile* preset = findPreset(kind, name)) return std::string(preset->text);
  const std::vector<std::string> names = presetNames(kind);
  if (names.empty()) return fail(ErrorCode::kUsage, fmt::format("there are no presets of kind '{}'", kind));
  return fail(ErrorCode::kUsage,
              fmt::format("'{}' is neither a file nor a preset of {}: {}.{}", printable(name), kind,
                          fmt::join(names, ", "), suggestion(name, names)));
}

}  // namespace fulbito
