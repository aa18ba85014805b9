// Private header of apps: not installed.
#pragma once

#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fulbito::app {

/// Makes all three standard descriptors open ones, so that no file gets the number of one that was closed.
/// What is written to a closed stdout counts as not written; words for a closed stderr are lost.
void openStandardDescriptors();

/// Writes to stdout, byte by byte as it is: for JSON, tables and files. What cannot be written is remembered
/// until `finishOutput`.
void writeOut(std::string_view text);
/// @{ Writes to stdout or stderr for people: control characters stand as \x1b, since names come from
/// anywhere.
void printOut(std::string_view text);
void printNote(std::string_view text);
template <typename... Args>
void say(fmt::format_string<Args...> format, Args&&... args) {
  printOut(fmt::format(format, std::forward<Args>(args)...));
}
template <typename... Args>
void note(fmt::format_string<Args...> format, Args&&... args) {
  printNote(fmt::format(format, std::forward<Args>(args)...));
}
/// @}
/// Hands all that was written to whoever reads it.
void flushOut();

/// Whether stderr is a terminal on which a line can be drawn anew.
bool drawsLines();

/// Flushes stdout and gives the program's exit code: `code`, or kIo and a message where a part of the results
/// was lost. A reader that has gone, as with `| head`, is no news: then without a message.
int finishOutput(int code);

}  // namespace fulbito::app
