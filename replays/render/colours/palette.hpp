#pragma once

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// Colours of field pictures, without the series (`seriesColour`).
namespace theme {
inline constexpr Colour kPage{15, 18, 23};
inline constexpr Colour kPanel{24, 29, 36};
inline constexpr Colour kRule{52, 60, 71};
inline constexpr Colour kText{233, 238, 244};
inline constexpr Colour kDimText{152, 164, 178};
inline constexpr Colour kWarningText{255, 138, 122};
inline constexpr Colour kWall{58, 67, 79};
inline constexpr Colour kFloor{26, 31, 37};
inline constexpr Colour kFieldLine{214, 220, 226};
inline constexpr Colour kMarker{255, 255, 255};
inline constexpr Colour kTennisBall{176, 208, 58};
inline constexpr Colour kPushable{226, 150, 118};
inline constexpr Colour kSeam{244, 247, 232};
}  // namespace theme

/// Colours of a field.
struct FieldColours {
  Colour wall, floor, left_goal, right_goal, line;
};

/// Number of different colours of `seriesColour`; further indices repeat them.
inline constexpr std::size_t kSeriesColours = 12;

/// The colour of the i-th path or bar, the same in every picture. Colour-blind readers can tell them apart.
Colour seriesColour(std::size_t index);

/// `colour` with the opacity `alpha`, 0...255.
constexpr Colour withAlpha(Colour colour, std::uint8_t alpha) {
  return {colour.r, colour.g, colour.b, alpha};
}

/// `colour` mixed with black; `share` 0...1 is the part of black.
Colour darkened(Colour colour, double share);

}  // namespace fulbito
