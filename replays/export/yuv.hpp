#pragma once

#include <string>

#include "fulbito/detail/canvas.hpp"

namespace fulbito {

/// Converts a picture with even sides to planes Y, U and V, with U and V at half size: BT.709, limited range,
/// as videos need. This halves the bytes on the pipe and spares ffmpeg the conversion.
void toYuv420(const Canvas& canvas, std::string& out);

}  // namespace fulbito
