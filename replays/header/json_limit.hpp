#pragma once

#include <cstddef>
#include <string_view>

namespace fulbito {

/// Largest number of keys and values in a JSON text of a recording: a hundred times what is written. Without
/// a limit, an ordered object would take quadratic time, since it searches all its keys for each new one.
inline constexpr std::size_t kMaxJsonItems = 8192;

/// Whether a text is JSON with at most `kMaxJsonItems` keys and values. Stops reading beyond that.
bool isSmallJson(std::string_view text);

}  // namespace fulbito
