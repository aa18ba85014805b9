#include "engine/core/base/assert.hpp"

#include <cstdio>
#include <cstdlib>

namespace fulbito::detail {

void demandFailed(const char* condition, const char* file, int line) {
  std::fprintf(stderr, "fulbito: internal error: %s does not hold (%s:%d)\n", condition, file, line);
  std::abort();
}

}  // namespace fulbito::detail
