#pragma once

#include <cstdint>
#include <string>

namespace fulbito {

/// How many bytes the file of a shared library has at least, by its own headers. The loader maps them, and a
/// process that touches what lies beyond a file's end is ended by a signal. 0 if it is no library for
/// machines of this kind: the loader says so itself.
std::uint64_t mappedLength(const std::string& file);

}  // namespace fulbito
