#include "replays/coding/compression.hpp"

#include <zstd.h>

namespace fulbito {
namespace {

// Of headers, plays and events, of which higher levels save some hundred bytes. Tables have models of their
// own.
constexpr int kLevel = 3;

}  // namespace

struct Compressor::Context {
  ZSTD_CCtx* zstd = ZSTD_createCCtx();
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context() { ZSTD_freeCCtx(zstd); }
};

Compressor::Compressor() : context_(std::make_unique<Context>()) {}
Compressor::Compressor(Compressor&&) noexcept = default;
Compressor& Compressor::operator=(Compressor&&) noexcept = default;
Compressor::~Compressor() = default;

Codec Compressor::append(std::span<const BytesView> parts, Bytes& out) {
  const std::size_t begin = out.size();
  std::size_t raw_size = 0;
  bool packed = context_->zstd != nullptr;
  for (const BytesView part : parts) {
    raw_size += part.size();
    if (!packed) continue;
    const std::size_t at = out.size();
    out.resize(at + ZSTD_compressBound(part.size()));
    const std::size_t size =
        ZSTD_compressCCtx(context_->zstd, out.data() + at, out.size() - at, part.data(), part.size(), kLevel);
    packed = ZSTD_isError(size) == 0;
    out.resize(packed ? at + size : at);
  }
  if (packed && out.size() - begin < raw_size) return Codec::kZstd;
  out.resize(begin);
  for (const BytesView part : parts) out.append(part);
  return Codec::kStored;
}

std::optional<Bytes> unpack(std::uint8_t codec, BytesView stored, std::size_t raw_size) {
  if (codec == static_cast<std::uint8_t>(Codec::kStored)) {
    if (stored.size() != raw_size) return std::nullopt;
    return Bytes(stored);
  }
  if (codec != static_cast<std::uint8_t>(Codec::kZstd)) return std::nullopt;
  Bytes raw(raw_size, '\0');
  const std::size_t size = ZSTD_decompress(raw.data(), raw.size(), stored.data(), stored.size());
  if (ZSTD_isError(size) != 0 || size != raw_size) return std::nullopt;
  return raw;
}

}  // namespace fulbito
