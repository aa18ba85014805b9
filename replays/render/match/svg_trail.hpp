#pragma once

#include <span>

#include "replays/render/match/svg_field.hpp"

namespace fulbito {

/// Draws a trail like `Canvas::fadingLine`: a band [px] that fades in to `colour` and changes its thickness
/// from `first` to `last`. It has twelve steps, because SVG has no gradient along a line.
void svgFadingLine(SvgText& svg, std::span<const Vec2> points, double first, double last, Colour colour);

}  // namespace fulbito
