#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/config/embedded_files.hpp"

namespace fulbito {

/// The text of the embedded file with this name; empty if there is none.
std::string_view textOfFile(std::span<const EmbeddedFile> files, std::string_view name);

/// Replaces each placeholder `{{name}}` in a form by the text with that name. Placeholders in the texts are
/// not replaced.
std::string filledForm(std::string_view form,
                       const std::vector<std::pair<std::string_view, std::string>>& texts);

/// The entry of a Content-Security-Policy that allows the script or style with this SHA-256 digest
/// (hexadecimal).
std::string allowedDigest(std::string_view digest);

}  // namespace fulbito
