#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "replays/html/html_page.hpp"

namespace fulbito {

/// Sizes and checksum of the page's binary data.
struct PagePayload {
  std::vector<std::size_t> sizes;  ///< size of each scene's columns [bytes], in order
  std::size_t raw = 0;             ///< total bytes
  std::size_t packed = 0;          ///< bytes after deflate
  std::uint32_t crc = 0;           ///< CRC-32 of all bytes before deflate
};

/// Everything except the values per tick, as JSON that is safe inside a script element: it contains no '<',
/// '>', '&' or non-ASCII character, whatever the texts are.
std::string pageJson(const Page& page, const PagePayload& payload);

}  // namespace fulbito
