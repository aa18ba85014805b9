#pragma once

#include "fulbito/detail/canvas.hpp"

/// Colours that all charts share.
namespace fulbito::chart_style {

inline constexpr Colour kPaper{252, 252, 250}, kInk{30, 35, 42}, kDimInk{104, 113, 124};
inline constexpr Colour kGrid{226, 229, 232}, kStripe{241, 243, 244}, kBaseLine{120, 128, 138};

}  // namespace fulbito::chart_style
