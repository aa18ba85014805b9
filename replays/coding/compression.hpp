#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>

#include "replays/coding/byte_io.hpp"

namespace fulbito {

/// How the bytes of a block or section are kept. The numbers stand in files.
enum class Codec : std::uint8_t {
  kStored = 0,
  kZstd = 1,
  kModelled = 2  ///< of a chunk's commands and samples: a model of their own, see command_code, sample_code
};

/// Packs bytes with zstd; keeps its tables between calls.
class Compressor {
 public:
  Compressor();
  Compressor(Compressor&&) noexcept;
  Compressor& operator=(Compressor&&) noexcept;
  ~Compressor();

  /// Appends the parts to `out`, each as a zstd frame of its own (each may then have its own statistics), or
  /// as they are where that is not longer.
  Codec append(std::span<const BytesView> parts, Bytes& out);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

/// The `raw_size` bytes that `stored` holds, which the caller has bounded. Empty when the codec is unknown or
/// the content is anything but that many bytes.
std::optional<Bytes> unpack(std::uint8_t codec, BytesView stored, std::size_t raw_size);

}  // namespace fulbito
