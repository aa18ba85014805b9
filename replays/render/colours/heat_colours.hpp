#pragma once

#include <array>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// Colours of a heat map, from 0 to the maximum. They are computed in Oklab (B. Ottosson, 2020) with equal
/// steps of lightness that lead away from the floor's. So equal differences look equal, also in grey and to
/// colour-blind readers.
std::array<Colour, 256> heatColours(PictureTheme theme);

}  // namespace fulbito
