#include "replays/export/gif.hpp"

#include <algorithm>
#include <array>
#include <cgif.h>
#include <limits>

namespace fulbito {
namespace {

constexpr std::size_t kMostColours = 255;  // one index is left for what did not change
constexpr std::size_t kKnown = 1u << 14;

int append(void* bytes, const std::uint8_t* data, std::size_t size) {
  static_cast<std::string*>(bytes)->append(reinterpret_cast<const char*>(data), size);
  return 0;
}

int part(std::uint32_t argb, int shift) { return static_cast<int>(argb >> shift & 255u); }

}  // namespace

GifPalette::GifPalette(const std::vector<const Canvas*>& samples) {
  std::map<std::uint32_t, std::size_t> counts;
  for (const Canvas* canvas : samples) {
    for (int y = 0; y < canvas->height(); ++y) {
      for (const std::uint32_t argb : canvas->row(y)) ++counts[argb];
    }
  }
  std::vector<std::pair<std::size_t, std::uint32_t>> order;
  order.reserve(counts.size());
  for (const auto& [argb, count] : counts) order.emplace_back(count, argb);
  std::sort(order.begin(), order.end(), [](const auto& a, const auto& b) {
    return a.first != b.first ? a.first > b.first : a.second < b.second;
  });
  for (const int apart : {40, 28, 20, 14, 9, 5, 1}) {
    for (const auto& [count, argb] : order) {
      if (colours_.size() >= 3 * kMostColours) return;
      if (leastDistance(argb) >= apart * apart) add(argb);
    }
  }
}

void GifPalette::add(std::uint32_t argb) {
  for (const int shift : {16, 8, 0}) colours_.push_back(static_cast<std::uint8_t>(argb >> shift));
}

/// Squared, green counting most, as the eye does.
int GifPalette::distanceTo(std::uint32_t argb, std::size_t index) const {
  const int r = part(argb, 16) - colours_[3 * index], g = part(argb, 8) - colours_[3 * index + 1],
            b = part(argb, 0) - colours_[3 * index + 2];
  return (3 * r * r + 6 * g * g + b * b) / 3;
}

int GifPalette::leastDistance(std::uint32_t argb) const {
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < colours_.size() / 3; ++i) least = std::min(least, distanceTo(argb, i));
  return least;
}

std::uint8_t GifPalette::nearest(std::uint32_t argb) const {
  std::size_t best = 0;
  int least = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < colours_.size() / 3; ++i) {
    if (const int d = distanceTo(argb, i); d < least) least = d, best = i;
  }
  return static_cast<std::uint8_t>(best);
}

GifIndexer::GifIndexer(const GifPalette& palette) : palette_(&palette), known_(kKnown) {}

std::uint8_t GifIndexer::lookUp(std::uint32_t argb) {
  Known& known = known_[(argb * 2654435761u) >> 18];
  if (known.argb != argb) known = {argb, palette_->nearest(argb)};  // 0, without opacity, is no picture's
  return known.index;
}

void GifIndexer::index(const Canvas& canvas, std::string& out) {
  out.clear();
  std::uint32_t last = 0;
  std::uint8_t index = 0;
  for (int y = 0; y < canvas.height(); ++y) {
    for (const std::uint32_t argb : canvas.row(y)) {
      if (argb != last) last = argb, index = lookUp(argb);
      out.push_back(static_cast<char>(index));
    }
  }
}

struct GifWriter::Impl {
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (gif != nullptr) cgif_close(gif);
  }

  std::string bytes;
  std::vector<std::uint8_t> palette;
  CGIF* gif = nullptr;
  std::uint16_t delay = 4;
};

GifWriter::GifWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
GifWriter::GifWriter(GifWriter&&) noexcept = default;
GifWriter& GifWriter::operator=(GifWriter&&) noexcept = default;
GifWriter::~GifWriter() = default;

Result<GifWriter> GifWriter::create(int width, int height, const GifPalette& palette, int centiseconds) {
  constexpr int kLongest = std::numeric_limits<std::uint16_t>::max();
  if (width > kLongest || height > kLongest) {
    return fail(ErrorCode::kUsage, "width and height of a GIF must be at most 65535 pixels");
  }
  auto impl = std::make_unique<Impl>();
  impl->palette = palette.colours();
  impl->delay = static_cast<std::uint16_t>(std::clamp(centiseconds, 2, kLongest));
  CGIF_Config config{};
  config.pGlobalPalette = impl->palette.data();
  config.numGlobalPaletteEntries = static_cast<std::uint16_t>(impl->palette.size() / 3);
  config.attrFlags = CGIF_ATTR_IS_ANIMATED;
  config.width = static_cast<std::uint16_t>(width);
  config.height = static_cast<std::uint16_t>(height);
  config.numLoops = CGIF_INFINITE_LOOP;
  config.pWriteFn = append;
  config.pContext = &impl->bytes;
  impl->gif = cgif_newgif(&config);
  if (impl->gif == nullptr) return fail(ErrorCode::kIo, "cannot start the GIF");
  return GifWriter(std::move(impl));
}

Result<void> GifWriter::add(std::string& indices) {
  CGIF_FrameConfig frame{};
  frame.pImageData = reinterpret_cast<std::uint8_t*>(indices.data());
  frame.genFlags = CGIF_FRAME_GEN_USE_TRANSPARENCY | CGIF_FRAME_GEN_USE_DIFF_WINDOW;
  frame.delay = impl_->delay;
  if (cgif_addframe(impl_->gif, &frame) != CGIF_OK) return fail(ErrorCode::kIo, "cannot write the GIF");
  return {};
}

Result<std::string> GifWriter::finish() {
  CGIF* gif = impl_->gif;
  impl_->gif = nullptr;
  if (cgif_close(gif) != CGIF_OK) return fail(ErrorCode::kIo, "cannot write the GIF");
  return std::move(impl_->bytes);
}

}  // namespace fulbito
