#include "replays/render/png_file.hpp"

#include <bit>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <png.h>

namespace fulbito {
namespace {

constexpr std::uint32_t kPixelFormat =
    std::endian::native == std::endian::little ? PNG_FORMAT_BGRA : PNG_FORMAT_ARGB;

/// Empty when written, else what went wrong.
std::string encode(std::FILE* out, int width, int height, const void* pixels, int pitch) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = kPixelFormat;
  errno = 0;
  if (png_image_write_to_stdio(&image, out, 0, pixels, pitch, nullptr) == 0) {
    return errno != 0 ? std::strerror(errno) : image.message;
  }
  return {};
}

tl::unexpected<Error> cannotWrite(const std::string& file, const std::string& reason) {
  return fail(ErrorCode::kIo, "cannot write " + file + ": " + reason);
}

}  // namespace

Result<void> writePngFile(const std::string& file, int width, int height, const void* pixels, int pitch) {
  const std::string part = file + ".part";
  std::FILE* out = std::fopen(part.c_str(), "wb");
  if (out == nullptr) return cannotWrite(file, std::strerror(errno));
  std::string wrong = encode(out, width, height, pixels, pitch);
  if (std::fclose(out) != 0 && wrong.empty()) wrong = std::strerror(errno);
  if (wrong.empty() && std::rename(part.c_str(), file.c_str()) != 0) wrong = std::strerror(errno);
  if (wrong.empty()) return {};
  std::remove(part.c_str());
  return cannotWrite(file, wrong);
}

}  // namespace fulbito
