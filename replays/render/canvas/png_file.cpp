#include "replays/render/canvas/png_file.hpp"

#include <cstdint>
#include <libdeflate.h>
#include <span>
#include <vector>

#include <png.h>

#include "engine/core/system/output_file.hpp"

namespace fulbito {
namespace {

const std::uint32_t* rowOf(const void* pixels, int pitch, int y) {
  return reinterpret_cast<const std::uint32_t*>(static_cast<const std::uint8_t*>(pixels) +
                                                std::ptrdiff_t{y} * pitch);
}

/// Converts rows to PNG bytes without a filter, which for flat colours is both the fastest and the smallest.
/// Returns the bitwise AND of all pixels.
template <std::size_t kChannels>
std::uint32_t convert(int width, int height, const void* pixels, int pitch, std::uint8_t* out) {
  std::uint32_t common = ~0u;
  for (int y = 0; y < height; ++y) {
    const std::uint32_t* row = rowOf(pixels, pitch, y);
    *out++ = 0;  // no filter
    for (int x = 0; x < width; ++x) {
      const std::uint32_t argb = row[x];
      common &= argb;
      out[0] = static_cast<std::uint8_t>(argb >> 16);
      out[1] = static_cast<std::uint8_t>(argb >> 8);
      out[2] = static_cast<std::uint8_t>(argb);
      if constexpr (kChannels == 4) out[3] = static_cast<std::uint8_t>(argb >> 24);
      out += kChannels;
    }
  }
  return common;
}

struct PngShape {
  int width, height;
  bool opaque;
};

void append(png_structp png, png_bytep data, std::size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(data), size);
}

void writeChunks(png_structp png, png_infop info, const PngShape& shape,
                 std::span<const std::uint8_t> packed) {
  png_set_IHDR(png, info, static_cast<png_uint_32>(shape.width), static_cast<png_uint_32>(shape.height), 8,
               shape.opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IDAT"), packed.data(), packed.size());
  png_write_chunk(png, reinterpret_cast<png_const_bytep>("IEND"), nullptr, 0);
}

/// Appends the PNG file to `out`. False if memory runs out.
bool writeContainer(const PngShape& shape, std::span<const std::uint8_t> packed, std::string* out) {
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  if (png == nullptr) return false;
  png_infop info = png_create_info_struct(png);
  if (info == nullptr || setjmp(png_jmpbuf(png)) != 0) {
    png_destroy_write_struct(&png, nullptr);
    return false;
  }
  png_set_write_fn(png, out, append, nullptr);
  writeChunks(png, info, shape, packed);
  png_destroy_write_struct(&png, &info);
  return true;
}

}  // namespace

void PngEncoder::Free::operator()(libdeflate_compressor* compressor) const {
  libdeflate_free_compressor(compressor);
}

std::string PngEncoder::encode(int width, int height, const void* pixels, int pitch, PngEffort effort) {
  if (!compressor_ || effort != effort_) {
    compressor_.reset(libdeflate_alloc_compressor(effort == PngEffort::kFast ? 1 : 9));
    effort_ = effort;
  }
  if (!compressor_) return {};
  const std::size_t area = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  PngShape shape{width, height, true};
  raw_.resize(3 * area + static_cast<std::size_t>(height));
  if (convert<3>(width, height, pixels, pitch, raw_.data()) < 0xff000000u) {
    shape.opaque = false;
    raw_.resize(4 * area + static_cast<std::size_t>(height));
    convert<4>(width, height, pixels, pitch, raw_.data());
  }
  packed_.resize(libdeflate_zlib_compress_bound(compressor_.get(), raw_.size()));
  const std::size_t size =
      libdeflate_zlib_compress(compressor_.get(), raw_.data(), raw_.size(), packed_.data(), packed_.size());
  std::string out;
  out.reserve(size + 256);
  if (size == 0 || !writeContainer(shape, {packed_.data(), size}, &out)) return {};
  return out;
}

Result<void> writePngFile(const std::string& file, const std::string& bytes) {
  if (bytes.empty()) return fail(ErrorCode::kMachine, "cannot write " + file + ": not enough memory");
  return writeFile(file, bytes);
}

}  // namespace fulbito
