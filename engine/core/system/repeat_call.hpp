#pragma once

#include <cerrno>

namespace fulbito {

/// The result of a system call, repeated while signals interrupt it.
template <typename Call>
auto repeatCall(const Call& call) {
  for (;;) {
    const auto result = call();
    if (result >= 0 || errno != EINTR) return result;
  }
}

}  // namespace fulbito
