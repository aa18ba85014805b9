#include "replays/export/gif.hpp"

#include <algorithm>
#include <array>
#include <gif_lib.h>
#include <limits>
#include <new>
#include <string_view>
#include <utility>

namespace fulbito {
namespace {

constexpr std::size_t kMostColours = 255;  // the last index of the GIF stands for unchanged pixels
constexpr std::size_t kKnown = 1u << 14;

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

/// Squared distance between colours. Green has the highest weight, because the eye is most sensitive to it.
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
  if (known.argb != argb) known = {argb, palette_->nearest(argb)};  // 0 is transparent: no picture has it
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

namespace {

constexpr int kKeepsPlace = 1;  // disposal method: the frame stays visible under the next one

struct ColourTableDeleter {
  void operator()(ColorMapObject* table) const { GifFreeMapObject(table); }
};

/// @return the colours, and one more that is never drawn: it stands for unchanged pixels
std::unique_ptr<ColorMapObject, ColourTableDeleter> colourTable(const std::vector<std::uint8_t>& colours) {
  const int count = static_cast<int>(colours.size() / 3);
  std::unique_ptr<ColorMapObject, ColourTableDeleter> table(
      GifMakeMapObject(1 << GifBitSize(count + 1), nullptr));
  if (table == nullptr) throw std::bad_alloc();
  for (std::size_t i = 0; i < colours.size() / 3; ++i) {
    table->Colors[i] = {colours[3 * i], colours[3 * i + 1], colours[3 * i + 2]};
  }
  return table;
}

/// A rectangle of a frame [px]; `right` and `bottom` are one past the end.
struct Window {
  int left, top, right, bottom;
};

/// The rectangle in which two frames differ. One pixel if they are equal, since a frame must not be empty.
Window changed(std::string_view before, std::string_view now, int width) {
  Window window{std::numeric_limits<int>::max(), std::numeric_limits<int>::max(), 0, 0};
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (before[i] == now[i]) continue;
    const int x = static_cast<int>(i) % width, y = static_cast<int>(i) / width;
    window = {std::min(window.left, x), std::min(window.top, y), std::max(window.right, x + 1),
              std::max(window.bottom, y + 1)};
  }
  return window.right > 0 ? window : Window{0, 0, 1, 1};
}

}  // namespace

struct GifWriter::Impl {
  Impl() = default;
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() {
    if (gif != nullptr) EGifCloseFile(gif, nullptr);
  }
  static int append(GifFileType* gif, const GifByteType* data, int size) {
    static_cast<Impl*>(gif->UserData)
        ->bytes.append(reinterpret_cast<const char*>(data), static_cast<std::size_t>(size));
    return size;
  }
  bool begin(const std::vector<std::uint8_t>& colours);
  bool loop() const;
  bool draw(const Window& window, std::string_view indices);

  std::string bytes;
  std::string shown;  ///< palette indices of the last frame; empty before the first frame
  std::string row;
  GifFileType* gif = nullptr;
  int width = 0, height = 0;   ///< [pixels]
  int delay = 4;               ///< [s/100]
  std::uint8_t unchanged = 0;  ///< palette index for unchanged pixels
};

bool GifWriter::Impl::begin(const std::vector<std::uint8_t>& colours) {
  const auto table = colourTable(colours);
  unchanged = static_cast<std::uint8_t>(colours.size() / 3);
  EGifSetGifVersion(gif, true);
  return EGifPutScreenDesc(gif, width, height, table->BitsPerPixel, 0, table.get()) == GIF_OK && loop();
}

/// Writes the extension that makes the film loop forever.
bool GifWriter::Impl::loop() const {
  constexpr std::string_view kName = "NETSCAPE2.0";
  constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
  return EGifPutExtensionLeader(gif, APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
         EGifPutExtensionBlock(gif, static_cast<int>(kName.size()), kName.data()) == GIF_OK &&
         EGifPutExtensionBlock(gif, static_cast<int>(kForEver.size()), kForEver.data()) == GIF_OK &&
         EGifPutExtensionTrailer(gif) == GIF_OK;
}

bool GifWriter::Impl::draw(const Window& window, std::string_view indices) {
  const GraphicsControlBlock control{kKeepsPlace, false, delay,
                                     shown.empty() ? NO_TRANSPARENT_COLOR : unchanged};
  std::array<GifByteType, 4> packed{};
  EGifGCBToExtension(&control, packed.data());
  const int columns = window.right - window.left;
  if (EGifPutExtension(gif, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(packed.size()), packed.data()) !=
          GIF_OK ||
      EGifPutImageDesc(gif, window.left, window.top, columns, window.bottom - window.top, false, nullptr) !=
          GIF_OK) {
    return false;
  }
  for (int y = window.top; y < window.bottom; ++y) {
    const auto from =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(window.left);
    row = indices.substr(from, static_cast<std::size_t>(columns));
    for (std::size_t i = 0; i < row.size() && !shown.empty(); ++i) {
      if (row[i] == shown[from + i]) row[i] = static_cast<char>(unchanged);
    }
    if (EGifPutLine(gif, reinterpret_cast<GifPixelType*>(row.data()), columns) != GIF_OK) return false;
  }
  return true;
}

GifWriter::GifWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
GifWriter::GifWriter(GifWriter&&) noexcept = default;
GifWriter& GifWriter::operator=(GifWriter&&) noexcept = default;
GifWriter::~GifWriter() = default;

namespace {

tl::unexpected<Error> failed(int error) {
  if (error == E_GIF_ERR_NOT_ENOUGH_MEM) throw std::bad_alloc();
  const char* why = GifErrorString(error);
  return fail(ErrorCode::kIo,
              std::string("cannot write the GIF: ") + (why != nullptr ? why : "unknown error"));
}

}  // namespace

Result<GifWriter> GifWriter::create(int width, int height, const GifPalette& palette, int centiseconds) {
  constexpr int kLongest = std::numeric_limits<std::uint16_t>::max();
  if (width > kLongest || height > kLongest) {
    return fail(ErrorCode::kUsage, "width and height of a GIF must be at most 65535 pixels");
  }
  auto impl = std::make_unique<Impl>();
  impl->width = width;
  impl->height = height;
  impl->delay = std::clamp(centiseconds, 2, kLongest);
  int error = 0;
  impl->gif = EGifOpen(impl.get(), Impl::append, &error);
  if (impl->gif == nullptr) return failed(error);
  if (!impl->begin(palette.colours())) return failed(impl->gif->Error);
  return GifWriter(std::move(impl));
}

Result<void> GifWriter::add(std::string_view indices) {
  Impl& impl = *impl_;
  const Window window =
      impl.shown.empty() ? Window{0, 0, impl.width, impl.height} : changed(impl.shown, indices, impl.width);
  if (!impl.draw(window, indices)) return failed(impl.gif->Error);
  impl.shown = indices;
  return {};
}

Result<std::string> GifWriter::finish() {
  int error = 0;
  if (EGifCloseFile(std::exchange(impl_->gif, nullptr), &error) != GIF_OK) return failed(error);
  return std::move(impl_->bytes);
}

}  // namespace fulbito
