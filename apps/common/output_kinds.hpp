#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "fulbito/detail/values.hpp"

namespace fulbito::app {

/// What an output file holds.
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

/// How an object of JSON begins that a command writes.
constexpr std::string_view kObjectBeginning = "{\n  \"schema_version\": ";

/// How the files of a kind begin.
std::string_view beginningOf(OutputKind kind);

/// The kind that the ending of a file's name promises, without regard to case; none for other endings.
std::optional<OutputKind> kindOfName(const std::string& file);

/// The beginning of a file; empty if there is none or it is no regular file.
std::string headOf(const std::string& file);

/// Whether the beginning of a file shows that this program wrote an output of that kind.
bool isOfKind(std::string_view head, OutputKind kind);

/// Whether the beginnings of two files show the same kind: both begin with what one kind of output begins
/// with, or, of other files, with the same line or, of tables, the same first column.
bool sameKind(std::string_view head, std::string_view other);

/// Whether the beginning is that of a file in which a tournament, a tuning or a cache keeps its results.
bool keepsResults(std::string_view head);

}  // namespace fulbito::app
