#include "replays/render/colours/palette.hpp"

#include "replays/render/colours/shared_colours.hpp"

namespace fulbito {

static_assert(kSeries.size() == kSeriesColours);

Colour seriesColour(std::size_t index) { return kSeries[index % kSeries.size()]; }

Colour darkened(Colour colour, double share) {
  const auto part = [share](std::uint8_t c) { return static_cast<std::uint8_t>(c * (1.0 - share)); };
  return {part(colour.r), part(colour.g), part(colour.b), colour.a};
}

}  // namespace fulbito
