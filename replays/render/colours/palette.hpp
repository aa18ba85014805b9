#pragma once

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// Colours of the field pictures; those of the series are `seriesColour`.
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

/// How many colours `seriesColour` has before it starts again.
inline constexpr std::size_t kSeriesColours = 12;

/// The colour that the i-th path or bar has in every picture of the project; distinguishable by colour-blind
/// readers.
Colour seriesColour(std::size_t index);

/// `colour` with another opacity 0...255.
constexpr Colour withAlpha(Colour colour, std::uint8_t alpha) {
  return {colour.r, colour.g, colour.b, alpha};
}

/// `colour` with `share` 0...1 of black mixed in.
Colour darkened(Colour colour, double share);

}  // namespace fulbito
