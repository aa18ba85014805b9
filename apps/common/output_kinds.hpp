#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fulbito/detail/values.hpp"

namespace fulbito::app {

/// The kinds of output files.
enum class OutputKind : std::uint8_t {
  kRecording,
  kPng,
  kGif,
  kSvg,
  kMp4,
  kWebm,
  kPage,  ///< HTML
  kCsv,
  kMarkdown,
  kJunit,
  kJsonLines
};

/// "a PNG picture", for messages.
const char* wordsOf(OutputKind kind);

/// The beginning of all JSON objects that commands write.
constexpr std::string_view kObjectBeginning = "{\n  \"schema_version\": ";

/// The first bytes of all files of a kind.
std::string_view beginningOf(OutputKind kind);

/// The kind that belongs to the ending of a file name, in upper or lower case. Empty for other endings.
std::optional<OutputKind> kindOfName(const std::string& file);

/// The first bytes of a file; empty if it does not exist or is not a regular file.
std::string headOf(const std::string& file);

/// Whether the first bytes of a file show that this program wrote it as an output of that kind.
bool isOfKind(std::string_view head, OutputKind kind);

/// Whether the first bytes of two files show the same kind. Both begin like the same kind of output; or, for
/// other files, with the same line or, for tables, with the same first column.
bool sameKind(std::string_view head, std::string_view other);

/// Whether the first bytes are those of a file with the results of a tournament, a tuning or a cache.
bool keepsResults(std::string_view head);

}  // namespace fulbito::app
