// Private header of replays/export: not installed.
#pragma once

#include <string>

#include "replays/render/canvas/canvas.hpp"

namespace fulbito {

/// A picture of even sides as planes Y, U, V, these at half the size: BT.709, limited range, as videos want
/// it. Half as many bytes for the pipe, and no work for ffmpeg.
void toYuv420(const Canvas& canvas, std::string& out);

}  // namespace fulbito
