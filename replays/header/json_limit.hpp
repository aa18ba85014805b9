// Private header of replays: not installed.
#pragma once

#include <cstddef>
#include <string_view>

namespace fulbito {

/// The most keys and values that a JSON text of a recording may have: a hundred times what is written. An
/// ordered object looks through all its keys for each new one.
inline constexpr std::size_t kMaxJsonItems = 8192;

/// Whether a text is JSON of at most `kMaxJsonItems` keys and values. Reads no further than that.
bool isSmallJson(std::string_view text);

}  // namespace fulbito
