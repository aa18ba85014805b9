// Private header of replays/html: not installed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fulbito {

/// Raw deflate (RFC 1951, no header or checksum), which browsers unpack by themselves. Same bytes for the
/// same version of libdeflate.
std::string deflated(std::string_view bytes);

/// CRC-32 as in PNG and gzip.
std::uint32_t crc32Of(std::string_view bytes);

}  // namespace fulbito
