#include "replays/render/colours/palette.hpp"

#include <array>

namespace fulbito {
namespace {

// Okabe and Ito's set for colour-blind readers (an indigo for their dark blue, no black), then
// five that keep as far from those and each other as can be in normal, protan, deutan and tritan vision.
constexpr std::array<Colour, kSeriesColours> kSeries{{{86, 180, 233},
                                                      {230, 159, 0},
                                                      {0, 158, 115},
                                                      {240, 228, 66},
                                                      {110, 70, 255},
                                                      {213, 94, 0},
                                                      {204, 121, 167},
                                                      {63, 224, 216},
                                                      {204, 0, 204},
                                                      {255, 187, 153},
                                                      {170, 119, 255},
                                                      {170, 85, 153}}};

}  // namespace

Colour seriesColour(std::size_t index) { return kSeries[index % kSeries.size()]; }

Colour darkened(Colour colour, double share) {
  const auto part = [share](std::uint8_t c) { return static_cast<std::uint8_t>(c * (1.0 - share)); };
  return {part(colour.r), part(colour.g), part(colour.b), colour.a};
}

}  // namespace fulbito
