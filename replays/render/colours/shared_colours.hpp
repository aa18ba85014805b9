#pragma once

#include <array>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// The opaque colour 0xRRGGBB.
constexpr Colour opaque(std::uint32_t rgb) {
  return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
          static_cast<std::uint8_t>(rgb)};
}

/// One theme's colours in shared_colours.def; the HTML viewer uses the same ones.
struct SharedColours {
#define SHARED_COLOUR(name, light, dark) Colour name;
#define SERIES_COLOUR(number, colour)
#include "replays/render/colours/shared_colours.def"
#undef SHARED_COLOUR
#undef SERIES_COLOUR
};

inline constexpr SharedColours kSharedLight{
#define SHARED_COLOUR(name, light, dark) .name = opaque(light),
#define SERIES_COLOUR(number, colour)
#include "replays/render/colours/shared_colours.def"
#undef SHARED_COLOUR
#undef SERIES_COLOUR
};

inline constexpr SharedColours kSharedDark{
#define SHARED_COLOUR(name, light, dark) .name = opaque(dark),
#define SERIES_COLOUR(number, colour)
#include "replays/render/colours/shared_colours.def"
#undef SHARED_COLOUR
#undef SERIES_COLOUR
};

/// Colours of the series, in order.
inline constexpr auto kSeries = std::to_array<Colour>({
#define SHARED_COLOUR(name, light, dark)
#define SERIES_COLOUR(number, colour) opaque(colour),
#include "replays/render/colours/shared_colours.def"
#undef SHARED_COLOUR
#undef SERIES_COLOUR
});

}  // namespace fulbito
