#include <string>
#include <unistd.h>

#include "tests/misbehaviour/kinds.hpp"

namespace fulbito::test {
namespace {

void garbage(const Scene&) {
  unsigned state = 12345;
  std::string bytes(4096, '\0');
  for (char& byte : bytes) {
    state = state * 1664525 + 1013904223;
    byte = static_cast<char>(state >> 24);
  }
  say(bytes);
  say("\n");
  waitForEver();
}

void longLine(const Scene&) {
  const std::string part(std::size_t{1} << 20, 'x');
  for (int k = 0; k < 64; ++k) say(part);
  say("\n");
  waitForEver();
}

[[noreturn]] void flood(int descriptor, const std::string& bytes) {
  for (;;) static_cast<void>(!::write(descriptor, bytes.data(), bytes.size()));
}

std::string lines() {
  std::string text;
  while (text.size() < 65536) text += "a line of a flood\n";
  return text;
}

constexpr Kind kFloods[] = {
    {"garbage", "says random bytes", garbage},
    {"half-line", "says half a line",
     [](const Scene&) {
       say("{\"type\":\"dec");
       waitForEver();
     }},
    {"long-line", "says a line of 64 MiB", longLine},
    {"endless-line", "says a line that never ends",
     [](const Scene&) { flood(STDOUT_FILENO, std::string(65536, ' ')); }},
    {"stdout-flood", "says lines for ever", [](const Scene&) { flood(STDOUT_FILENO, lines()); }},
    {"empty-lines", "says empty lines for ever",
     [](const Scene&) { flood(STDOUT_FILENO, std::string(65536, '\n')); }},
    {"stderr-flood", "complains for ever", [](const Scene&) { flood(STDERR_FILENO, lines()); }},
};

}  // namespace

std::span<const Kind> floods() { return kFloods; }

}  // namespace fulbito::test
