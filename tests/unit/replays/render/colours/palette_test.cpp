#include "replays/render/colours/palette.hpp"

#include <array>
#include <cmath>

#include "fulbito/picture.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

using Triple = std::array<double, 3>;
using Matrix = std::array<Triple, 3>;

constexpr Matrix kNormal{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
// Simulation of colour vision by Machado, Oliveira and Fernandes (2009), severity 1, for linear RGB.
constexpr Matrix kProtan{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Matrix kDeutan{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr Matrix kTritan{
    {{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}};

Triple apply(const Matrix& m, const Triple& v) {
  Triple out{};
  for (std::size_t i = 0; i < 3; ++i) out[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
  return out;
}

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Oklab coordinates (Ottosson 2020) of a colour as this viewer sees it.
Triple oklab(Colour colour, const Matrix& viewer) {
  Triple rgb = apply(viewer, {linear(colour.r), linear(colour.g), linear(colour.b)});
  for (double& c : rgb) c = std::clamp(c, 0.0, 1.0);
  Triple lms = apply({{{0.4122214708, 0.5363325363, 0.0514459929},
                       {0.2119034982, 0.6806995451, 0.1073969566},
                       {0.0883024619, 0.2817188376, 0.6299787005}}},
                     rgb);
  for (double& c : lms) c = std::cbrt(c);
  return apply({{{0.2104542553, 0.7936177850, -0.0040720468},
                 {1.9779984951, -2.4285922050, 0.4505937099},
                 {0.0259040371, 0.7827717662, -0.8086757660}}},
               lms);
}

double difference(Colour a, Colour b, const Matrix& viewer) {
  const Triple p = oklab(a, viewer), q = oklab(b, viewer);
  return std::sqrt((p[0] - q[0]) * (p[0] - q[0]) + (p[1] - q[1]) * (p[1] - q[1]) +
                   (p[2] - q[2]) * (p[2] - q[2]));
}

}  // namespace

// The smallest distance between Okabe and Ito's own seven colours is 0.076 in this measure.
TEST_CASE("twelve series colours are as distinct to colour-blind readers as the known set of seven",
          "[unit]") {
  for (const Matrix& viewer : {kNormal, kProtan, kDeutan, kTritan}) {
    for (std::size_t i = 0; i < kSeriesColours; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        CAPTURE(i, j);
        CHECK(difference(seriesColour(i), seriesColour(j), viewer) > 0.075);
      }
    }
  }
}

TEST_CASE("series colours stand out from the dark field and from paper", "[unit]") {
  for (std::size_t i = 0; i < kSeriesColours; ++i) {
    CAPTURE(i);
    CHECK(oklab(seriesColour(i), kNormal)[0] - oklab(theme::kFloor, kNormal)[0] > 0.3);
    CHECK(difference(seriesColour(i), {252, 252, 250}, kNormal) > 0.15);
  }
}

TEST_CASE("series colours start again after the last", "[unit]") {
  CHECK(seriesColour(kSeriesColours).r == seriesColour(0).r);
  CHECK(seriesColour(kSeriesColours + 3).g == seriesColour(3).g);
}

}  // namespace fulbito
