#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "fulbito/detail/canvas.hpp"
#include "fulbito/detail/values.hpp"

namespace fulbito {

/// The palette of a GIF, at most 255 colours: the most frequent ones of some pictures. Similar colours are
/// skipped while others are available.
class GifPalette {
 public:
  explicit GifPalette(const std::vector<const Canvas*>& samples);

  /// 3 bytes per colour.
  const std::vector<std::uint8_t>& colours() const { return colours_; }
  std::uint8_t nearest(std::uint32_t argb) const;

 private:
  void add(std::uint32_t argb);
  int distanceTo(std::uint32_t argb, std::size_t index) const;
  int leastDistance(std::uint32_t argb) const;

  std::vector<std::uint8_t> colours_;
};

/// Converts pictures to palette indices. Each thread needs its own.
class GifIndexer {
 public:
  explicit GifIndexer(const GifPalette& palette);
  /// One byte per pixel, row by row.
  void index(const Canvas& canvas, std::string& out);

 private:
  struct Known {
    std::uint32_t argb = 0;
    std::uint8_t index = 0;
  };

  std::uint8_t lookUp(std::uint32_t argb);

  const GifPalette* palette_;
  std::vector<Known> known_;  ///< cache, indexed by a hash of the colour
};

/// A looping GIF in memory, written frame by frame.
class GifWriter {
 public:
  /// `centiseconds`: duration of each frame, at least 2 (browsers slow down shorter ones).
  /// Errors: kUsage for sides above 65535.
  static Result<GifWriter> create(int width, int height, const GifPalette& palette, int centiseconds);
  GifWriter(GifWriter&&) noexcept;
  GifWriter& operator=(GifWriter&&) noexcept;
  ~GifWriter();

  /// Adds a frame from GifIndexer. Errors: kIo.
  Result<void> add(std::string_view indices);
  /// The whole file. Errors: kIo.
  Result<std::string> finish();

 private:
  struct Impl;
  explicit GifWriter(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
