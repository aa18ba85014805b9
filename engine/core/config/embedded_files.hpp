#pragma once

#include <span>
#include <string_view>

namespace fulbito {

/// A preset file embedded in the program.
struct EmbeddedFile {
  std::string_view kind;  ///< folder: robots, physics, fields
  std::string_view name;
  std::string_view text;
  std::string_view file;  ///< name with its ending
};

/// All presets of this library, in a fixed order.
std::span<const EmbeddedFile> embeddedPresets();

/// Whether `name_or_file` is always a file, never a preset: it contains a '/' or ends in ".toml".
bool isFileName(std::string_view name_or_file);

}  // namespace fulbito
