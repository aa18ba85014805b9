#include "navigation/library/plugin_values.hpp"

#include <cstring>

#include "engine/core/system/error_text.hpp"

namespace fulbito {

void toAbi(std::string_view text, char (&to)[FULBITO_NAME_SIZE]) {
  const std::string_view kept = firstBytes(text, FULBITO_NAME_SIZE - 1);
  std::memset(to, 0, sizeof to);
  if (!kept.empty()) std::memcpy(to, kept.data(), kept.size());  // an empty view may have no text
}

}  // namespace fulbito
