#pragma once

#include <cstdint>
#include <string>

namespace fulbito {

/// The number of bytes that the file of a shared library needs at least, by its own headers. The loader maps
/// this many bytes, and the system ends a process that reads mapped bytes beyond the end of the file. 0 if
/// the file is no library for this kind of machine; the loader reports that.
std::uint64_t mappedLength(const std::string& file);

}  // namespace fulbito
