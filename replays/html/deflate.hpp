#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fulbito {

/// Raw deflate (RFC 1951, without header or checksum), which browsers can unpack. The same version of
/// libdeflate gives the same bytes.
std::string deflated(std::string_view bytes);

/// CRC-32 as in PNG and gzip.
std::uint32_t crc32Of(std::string_view bytes);

}  // namespace fulbito
