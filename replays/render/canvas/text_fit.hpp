#pragma once

#include <string>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// `utf8` if it is at most `width` [px] wide, else its longest beginning that fits together with an ellipsis.
/// Empty if not even the ellipsis fits.
std::string fitted(const Canvas& canvas, const std::string& utf8, double size, double width);

}  // namespace fulbito
