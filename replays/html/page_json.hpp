// Private header of replays/html: not installed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "replays/html/html_page.hpp"

namespace fulbito {

/// Where the page's numbers are.
struct PagePayload {
  std::vector<std::size_t> sizes;  ///< bytes of each scene's columns, one after the other
  std::size_t raw = 0;             ///< of all
  std::size_t packed = 0;          ///< after deflate
  std::uint32_t crc = 0;           ///< of all, before deflate
};

/// All but the numbers of every tick, as JSON that may stand in a script element: whatever is in the texts,
/// there is no '<', '>', '&' or character beyond ASCII in it.
std::string pageJson(const Page& page, const PagePayload& payload);

}  // namespace fulbito
