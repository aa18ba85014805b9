#pragma once

#include <string>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// A picture with even sides as planes Y, U and V (U and V at half size): BT.709, limited range, as videos
/// need it. This halves the bytes on the pipe and saves ffmpeg the conversion.
void toYuv420(const Canvas& canvas, std::string& out);

}  // namespace fulbito
