#include "apps/whole_number.hpp"

#include <charconv>
#include <cstdint>

namespace fulbito::app {

std::string wholeNumberFlaw(const std::string& text) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (read.ec == std::errc() && read.ptr == end) return {};
  return "'" + text + "' is not a whole number, 0 ... 18446744073709551615";
}

}  // namespace fulbito::app
