#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "replays/coding/byte_io.hpp"

struct libdeflate_compressor;

/// Raw deflate (RFC 1951, without header or checksum). Recordings and pages use it, as browsers can unpack
/// it. The same version of libdeflate gives the same bytes.
namespace fulbito {

/// Deflates bytes. Keeps its tables between calls.
class Packer {
 public:
  enum Effort : int { kFast = 6, kSmallest = 12 };
  explicit Packer(Effort effort);

  /// Appends only the deflated bytes.
  void deflate(BytesView raw, Bytes& out) const;
  /// Appends a varint, the number of raw bytes, and then the deflated bytes.
  void pack(BytesView raw, Bytes& out) const;

 private:
  struct Free {
    void operator()(libdeflate_compressor* compressor) const;
  };
  std::unique_ptr<libdeflate_compressor, Free> compressor_;
};

/// The bytes deflated at the highest compression level.
std::string deflated(std::string_view bytes);

/// Undoes `Packer::pack`. Empty if the result has more than `most` bytes or the input is damaged.
std::optional<Bytes> unpacked(BytesView packed, std::size_t most);

/// CRC-32 as in PNG and gzip.
std::uint32_t crc32Of(std::string_view bytes);

}  // namespace fulbito
