#pragma once

#include <array>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// Colours from nothing to much. They are made in Oklab (B. Ottosson, 2020) with equal steps of lightness,
/// away from the floor's, so that equal differences look equal, also in grey and to colour-blind readers.
std::array<Colour, 256> heatColours(PictureTheme theme);

}  // namespace fulbito
