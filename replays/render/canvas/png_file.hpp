#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "fulbito/detail/canvas.hpp"
#include "fulbito/detail/values.hpp"

struct libdeflate_compressor;

namespace fulbito {

/// Creates PNG files in memory. libpng writes the container; libdeflate packs the pixels in half of zlib's
/// time.
class PngEncoder {
 public:
  /// Encodes pixels as an 8-bit PNG: RGB, or RGBA if a pixel is not opaque. A pixel is 32 bits, 0xAARRGGBB in
  /// the machine's byte order; rows are `pitch` bytes apart. Empty if memory runs out.
  std::string encode(int width, int height, const void* pixels, int pitch, PngEffort effort);

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const;
  };

  std::unique_ptr<libdeflate_compressor, Free> compressor_;
  PngEffort effort_ = PngEffort::kFast;
  std::vector<std::uint8_t> raw_, packed_;  ///< reused for the next picture
};

/// Writes the bytes of a picture by `writeFile`. Empty bytes mean that memory ran out. Errors: kIo naming the
/// file.
Result<void> writePngFile(const std::string& file, const std::string& bytes);

}  // namespace fulbito
