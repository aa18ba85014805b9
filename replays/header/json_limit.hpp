#pragma once

#include <cstddef>
#include <string_view>

namespace fulbito {

/// Largest number of keys and values in a JSON text of a recording, a hundred times what the writer produces.
/// Ordered objects search all their keys for each new one, so large ones would take quadratic time.
inline constexpr std::size_t kMaxJsonItems = 8192;

/// Whether a text is JSON with at most `kMaxJsonItems` keys and values. Stops reading beyond that.
bool isSmallJson(std::string_view text);

}  // namespace fulbito
