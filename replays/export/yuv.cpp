#include "replays/export/yuv.hpp"

#include <cstdint>

namespace fulbito {
namespace {

struct Rgb {
  int r, g, b;
};

Rgb unpack(std::uint32_t argb) {
  return {static_cast<int>(argb >> 16 & 255), static_cast<int>(argb >> 8 & 255),
          static_cast<int>(argb & 255)};
}

std::uint8_t luma(Rgb c) {
  return static_cast<std::uint8_t>(16 + ((47 * c.r + 157 * c.g + 16 * c.b + 128) >> 8));
}

}  // namespace

void toYuv420(const Canvas& canvas, std::string& out) {
  const auto width = static_cast<std::size_t>(canvas.width());
  const auto height = static_cast<std::size_t>(canvas.height()), area = width * height;
  out.resize(area + area / 2);
  auto* y_plane = reinterpret_cast<std::uint8_t*>(out.data());
  auto* u_plane = y_plane + area;
  auto* v_plane = u_plane + area / 4;
  for (std::size_t y = 0; y < height; y += 2) {
    const auto upper = canvas.row(static_cast<int>(y)), lower = canvas.row(static_cast<int>(y) + 1);
    std::uint8_t *first = y_plane + y * width, *second = first + width;
    for (std::size_t x = 0; x < width; x += 2) {
      const Rgb a = unpack(upper[x]), b = unpack(upper[x + 1]), c = unpack(lower[x]),
                d = unpack(lower[x + 1]);
      first[x] = luma(a);
      first[x + 1] = luma(b);
      second[x] = luma(c);
      second[x + 1] = luma(d);
      const Rgb sum{a.r + b.r + c.r + d.r, a.g + b.g + c.g + d.g, a.b + b.b + c.b + d.b};
      *u_plane++ = static_cast<std::uint8_t>(128 + ((-26 * sum.r - 86 * sum.g + 112 * sum.b + 512) >> 10));
      *v_plane++ = static_cast<std::uint8_t>(128 + ((112 * sum.r - 102 * sum.g - 10 * sum.b + 512) >> 10));
    }
  }
}

}  // namespace fulbito
