#include "engine/core/base/assert.hpp"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <string>

namespace fulbito::detail {
namespace {

std::atomic<bool> throws = false;

}  // namespace

void throwOnBrokenDemand() noexcept { throws = true; }

void demandFailed(const char* condition, const char* file, int line) {
  const std::string text = std::string("internal error: ") + condition + " does not hold (" + file + ":" +
                           std::to_string(line) + ")";
  if (throws) throw BrokenDemand(text);
  std::fprintf(stderr, "fulbito: %s\n", text.c_str());
  std::abort();
}

}  // namespace fulbito::detail
