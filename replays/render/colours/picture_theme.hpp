#pragma once

#include <cstdint>

namespace fulbito {

/// Which colours a match's picture has.
enum class PictureTheme : std::uint8_t { kDark, kLight };

}  // namespace fulbito
