#include <csignal>
#include <cstdlib>
#include <sys/mman.h>
#include <unistd.h>

#include "tests/misbehaviour/kinds.hpp"

namespace fulbito::test {
namespace {

void segfault(const Scene&) {
  auto* page =
      static_cast<volatile char*>(::mmap(nullptr, 4096, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  *page = 1;
}

[[gnu::noinline]] int deeper(int depth) {
  volatile char room[4096] = {};
  room[static_cast<std::size_t>(depth) % sizeof room] = 1;
  return depth < 0 ? 0 : deeper(depth + 1) + room[0];
}

constexpr Kind kCrashes[] = {
    {"segfault", "writes where it must not", segfault},
    {"abort", "aborts", [](const Scene&) { std::abort(); }},
    {"illegal-instruction", "runs what is no instruction", [](const Scene&) { ::raise(SIGILL); }},
    {"divide-by-zero", "divides by zero", [](const Scene&) { ::raise(SIGFPE); }},
    {"stack-overflow", "calls itself for ever", [](const Scene&) { std::exit(deeper(0)); }},
    {"exit-zero", "ends as if all were well", [](const Scene&) { ::_exit(0); }},
    {"exit-code", "ends with code 7", [](const Scene&) { ::_exit(7); }},
    {"kill-itself", "kills itself", [](const Scene&) { ::raise(SIGKILL); }},
    {"kill-group", "kills its process group", [](const Scene&) { ::kill(0, SIGKILL); }},
    {"kill-all", "kills all that it can reach, then itself",
     [](const Scene&) {
       ::kill(-1, SIGKILL);
       ::raise(SIGKILL);
     }},
};

}  // namespace

std::span<const Kind> crashes() { return kCrashes; }

}  // namespace fulbito::test
