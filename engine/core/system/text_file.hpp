#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The whole content of a file that the user names. Reads at most `max_bytes` + 1 bytes, whatever size the
/// file claims. Stops early if the file does not begin with `beginning`. For a pipe, it waits some seconds
/// for a writer, then until the writer ends. Errors: kIo naming the file and the reason; kBadInput when it is
/// larger than `max_bytes`; kInterrupted while it waits for a pipe.
Result<std::string> readTextFile(const std::string& path, std::size_t max_bytes,
                                 std::string_view beginning = {});

/// The same for a file that a folder's listing or the program names, not the user. Never waits. Errors: as
/// `readTextFile`; kIo also if it is no regular file.
Result<std::string> readFoundFile(const std::string& path, std::size_t max_bytes,
                                  std::string_view beginning = {});

}  // namespace fulbito
