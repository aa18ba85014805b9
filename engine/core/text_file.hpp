// Private header of engine/core: not installed.
#pragma once

#include <cstddef>
#include <string>

#include "engine/core/result.hpp"

namespace fulbito {

/// The whole content of a file. Reads at most `max_bytes` + 1 bytes whatever the file claims to be.
/// Errors: kIo naming the file and the reason; kBadInput when it is larger than `max_bytes`.
Result<std::string> readTextFile(const std::string& path, std::size_t max_bytes);

}  // namespace fulbito
