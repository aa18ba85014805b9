#pragma once

#include <span>

#include "replays/render/match/svg_field.hpp"

namespace fulbito {

/// A trail as `Canvas::fadingLine` draws it: a band [px] that goes from nothing to `colour` and from the
/// thickness `first` to `last`, in twelve steps, since SVG knows no gradient along a line.
void svgFadingLine(SvgText& svg, std::span<const Vec2> points, double first, double last, Colour colour);

}  // namespace fulbito
