// Private header of replays/render: not installed.
#pragma once

#include <string>

#include "engine/core/result.hpp"

namespace fulbito {

/// Writes pixels of 32 bits, 0xAARRGGBB in the machine's byte order, rows `pitch` bytes apart, as an 8-bit
/// RGB(A) PNG file. It goes to `file` + ".part" first and is renamed when complete: `file` never holds half a
/// picture, and an older one stays when writing fails. Errors: kIo naming the file.
Result<void> writePngFile(const std::string& file, int width, int height, const void* pixels, int pitch);

}  // namespace fulbito
