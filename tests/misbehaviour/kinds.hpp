#pragma once

#include <span>
#include <string>
#include <string_view>

namespace fulbito::test {

/// What a kind of misbehaviour has at hand.
struct Scene {
  std::string victim;  ///< a file or folder that the team must not touch; empty: none given
  std::string type;    ///< of the request to answer, such as "decide"; empty: there is none
  long id = 0;         ///< of the request to answer
};

/// A way to misbehave.
struct Kind {
  std::string_view name;
  std::string_view what;
  void (*act)(const Scene& scene);
  /// It tries something that must be refused, says so on standard error, and goes on as a good team.
  bool goes_on = false;
  /// It answers a request in a wrong way: for conversations only.
  bool answers = false;
};

/// @{ The kinds, by what they are about.
std::span<const Kind> crashes();
std::span<const Kind> silences();
std::span<const Kind> floods();
std::span<const Kind> bombs();
std::span<const Kind> escapes();
std::span<const Kind> attacks();
std::span<const Kind> wrongAnswers();
/// @}

/// Tells on standard error how an attempt went: "refused" with the error, or "GOT THROUGH".
void tell(std::string_view attempt, bool got_through);

/// Writes all bytes to standard output, whatever it takes.
void say(std::string_view bytes);

/// Waits for ever.
[[noreturn]] void waitForEver();

}  // namespace fulbito::test
