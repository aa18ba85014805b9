#include "replays/render/colours/heat_colours.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

std::uint8_t encoded(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double srgb = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(srgb * 255.0));
}

/// Converts a colour in Oklch (lightness, chroma, hue [degrees]) to sRGB.
Colour fromOklch(double lightness, double chroma, double hue) {
  const Vec2 ab = math::unit(math::wrapAngle(hue * math::kPi / 180.0)) * chroma;
  const auto cubed = [](double x) { return x * x * x; };
  const double l = cubed(lightness + 0.3963377774 * ab.x + 0.2158037573 * ab.y);
  const double m = cubed(lightness - 0.1055613458 * ab.x - 0.0638541728 * ab.y);
  const double s = cubed(lightness - 0.0894841775 * ab.x - 1.2914855480 * ab.y);
  return {encoded(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          encoded(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          encoded(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

}  // namespace

std::array<Colour, 256> heatColours(PictureTheme theme) {
  std::array<Colour, 256> colours;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    const double t = static_cast<double>(i) / 255.0;
    const double chroma = 0.02 + 0.15 * std::min(1.0, 3.0 * t) * (1.0 - 0.25 * t);
    if (theme == PictureTheme::kDark) {  // from the dark floor over violet and orange to light yellow
      colours[i] = fromOklch(0.24 + 0.68 * t, chroma, 275.0 + 185.0 * t);
    } else {  // from the light floor over yellow and red to dark violet
      colours[i] = fromOklch(0.94 - 0.62 * t, chroma, 100.0 - 180.0 * t);
    }
  }
  return colours;
}

}  // namespace fulbito
