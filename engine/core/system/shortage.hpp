#pragma once

#include <cerrno>

namespace fulbito {

/// Whether an errno says that the machine runs short of descriptors, processes or memory.
constexpr bool isShortage(int error) {
  return error == EMFILE || error == ENFILE || error == EAGAIN || error == ENOMEM || error == ENOBUFS;
}

}  // namespace fulbito
