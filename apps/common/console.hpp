#pragma once

#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace fulbito::app {

/// Opens closed standard descriptors on /dev/null, so that no other file gets their numbers. Writing to a
/// closed stdout counts as a failed write; text for a closed stderr is dropped.
void openStandardDescriptors();

/// Writes bytes to stdout unchanged: JSON, tables and files. `finishOutput` reports failures.
void writeOut(std::string_view text);
/// @{ Writes text for people to stdout or stderr. Control characters appear as \x1b, since names may contain
/// them.
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
/// Flushes stdout.
void flushOut();

/// Whether stderr is a terminal that can redraw a line.
bool drawsLines();

/// Flushes stdout and returns the program's exit code: `code`, or kIo with a message if output was lost. A
/// closed pipe, as with `| head`, gives kIo without a message.
int finishOutput(int code);

}  // namespace fulbito::app
