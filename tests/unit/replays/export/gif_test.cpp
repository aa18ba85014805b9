#include "replays/export/gif.hpp"

#include <algorithm>
#include <gif_lib.h>
#include <vector>

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

Canvas sheet(Colour background) {
  Canvas canvas = *Canvas::create(40, 30, background);
  canvas.fillCircle({20, 15}, 9, {250, 120, 20});
  return canvas;
}

std::uint32_t colourOf(const GifPalette& palette, std::uint8_t index) {
  const auto& c = palette.colours();
  const std::size_t i = 3 * std::size_t{index};
  return 0xff000000u | static_cast<std::uint32_t>(c[i]) << 16 | static_cast<std::uint32_t>(c[i + 1]) << 8 |
         c[i + 2];
}

/// The picture that a viewer shows after each frame, as palette indices.
std::vector<std::string> framesOf(std::string& bytes) {
  std::string_view rest = bytes;
  const auto read = [](GifFileType* gif, GifByteType* into, int size) {
    auto& left = *static_cast<std::string_view*>(gif->UserData);
    const auto count = left.copy(reinterpret_cast<char*>(into), static_cast<std::size_t>(size));
    left.remove_prefix(count);
    return static_cast<int>(count);
  };
  GifFileType* gif = DGifOpen(&rest, read, nullptr);
  REQUIRE(gif != nullptr);
  REQUIRE(DGifSlurp(gif) == GIF_OK);
  std::vector<std::string> frames;
  std::string shown(static_cast<std::size_t>(gif->SWidth * gif->SHeight), '\0');
  for (int i = 0; i < gif->ImageCount; ++i) {
    const SavedImage& image = gif->SavedImages[i];
    const GifImageDesc& place = image.ImageDesc;
    GraphicsControlBlock control{};
    DGifSavedExtensionToGCB(gif, i, &control);
    CHECK(control.DelayTime == 8);
    for (int k = 0; k < place.Width * place.Height; ++k) {
      const int x = place.Left + k % place.Width, y = place.Top + k / place.Width;
      const auto index = image.RasterBits[k];
      if (index != control.TransparentColor)
        shown[static_cast<std::size_t>(y * gif->SWidth + x)] = static_cast<char>(index);
    }
    frames.push_back(shown);
  }
  DGifCloseFile(gif, nullptr);
  return frames;
}

}  // namespace

TEST_CASE("few colours are kept as they are", "[unit]") {
  const Canvas canvas = sheet({10, 20, 30});
  const GifPalette palette({&canvas});
  REQUIRE(palette.colours().size() <= 3 * 255);
  std::string indices;
  GifIndexer(palette).index(canvas, indices);
  REQUIRE(indices.size() == 40 * 30);
  for (int y = 0; y < 30; ++y) {
    for (int x = 0; x < 40; ++x) {
      const auto index = static_cast<std::uint8_t>(indices[static_cast<std::size_t>(40 * y + x)]);
      REQUIRE(colourOf(palette, index) == canvas.row(y)[static_cast<std::size_t>(x)]);
    }
  }
}

TEST_CASE("many colours become near ones, the most frequent ones stay", "[unit]") {
  Canvas canvas = *Canvas::create(256, 64, {1, 2, 3});
  for (int y = 0; y < 16; ++y) {
    for (int x = 0; x < 256; ++x) {
      canvas.fillPixel(x, y, {static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(16 * y), 90});
    }
  }
  const GifPalette palette({&canvas});
  CHECK(palette.colours().size() == 3 * 255);
  CHECK(colourOf(palette, palette.nearest(0xff010203u)) == 0xff010203u);
  const std::uint32_t near = colourOf(palette, palette.nearest(0xff80805au));
  CHECK(std::abs(static_cast<int>(near >> 16 & 255) - 0x80) < 24);
}

TEST_CASE("a GIF shows every frame as it is", "[unit]") {
  std::vector<Canvas> frames;
  for (const int x : {8, 20, 20, 39, 0}) {  // two of the frames are equal
    frames.push_back(*Canvas::create(40, 30, {10, 20, 30}));
    frames.back().fillCircle({static_cast<double>(x), 15}, 5, {250, 120, 20});
  }
  const GifPalette palette({&frames[0], &frames[1]});
  auto gif = GifWriter::create(40, 30, palette, 8);
  REQUIRE(gif);
  GifIndexer indexer(palette);
  std::vector<std::string> written(frames.size());
  for (std::size_t i = 0; i < frames.size(); ++i) {
    indexer.index(frames[i], written[i]);
    REQUIRE(gif->add(written[i]));
  }
  std::string bytes = *gif->finish();
  CHECK(framesOf(bytes) == written);
}

TEST_CASE("a GIF has its size, its frames and its end", "[unit]") {
  const Canvas a = sheet({10, 20, 30}), b = sheet({200, 20, 30});
  const GifPalette palette({&a, &b});
  auto gif = GifWriter::create(40, 30, palette, 8);
  REQUIRE(gif);
  GifIndexer indexer(palette);
  std::string indices;
  for (const Canvas* canvas : {&a, &b, &a}) {
    indexer.index(*canvas, indices);
    REQUIRE(gif->add(indices));
  }
  const auto bytes = gif->finish();
  REQUIRE(bytes);
  CHECK(bytes->starts_with("GIF89a"));
  CHECK((*bytes)[6] == 40);
  CHECK((*bytes)[8] == 30);
  CHECK(bytes->back() == ';');
  CHECK(GifWriter::create(70000, 30, palette, 8).error().code == ErrorCode::kUsage);
}

}  // namespace fulbito
