#include "replays/coding/packing.hpp"

#include <libdeflate.h>
#include <new>

namespace fulbito {

void Packer::Free::operator()(libdeflate_compressor* compressor) const {
  libdeflate_free_compressor(compressor);
}

Packer::Packer(Effort effort) : compressor_(libdeflate_alloc_compressor(effort)) {
  if (!compressor_) throw std::bad_alloc();
}

void Packer::deflate(BytesView raw, Bytes& out) const {
  const std::size_t begin = out.size();
  out.resize(begin + libdeflate_deflate_compress_bound(compressor_.get(), raw.size()));
  out.resize(begin + libdeflate_deflate_compress(compressor_.get(), raw.data(), raw.size(),
                                                 out.data() + begin, out.size() - begin));
}

void Packer::pack(BytesView raw, Bytes& out) const {
  ByteWriter(out).varint(raw.size());
  deflate(raw, out);
}

std::string deflated(std::string_view bytes) {
  std::string out;
  Packer(Packer::kSmallest).deflate(bytes, out);
  return out;
}

std::optional<Bytes> unpacked(BytesView packed, std::size_t most) {
  ByteReader in(packed);
  Bytes raw(static_cast<std::size_t>(in.varint(most)), '\0');
  if (!in.good()) return std::nullopt;
  const BytesView deflated = in.bytes(in.left());
  const std::unique_ptr<libdeflate_decompressor, decltype(&libdeflate_free_decompressor)> decompressor(
      libdeflate_alloc_decompressor(), &libdeflate_free_decompressor);
  if (!decompressor) throw std::bad_alloc();
  std::size_t used = 0;
  const auto outcome = libdeflate_deflate_decompress_ex(decompressor.get(), deflated.data(), deflated.size(),
                                                        raw.data(), raw.size(), &used, nullptr);
  if (outcome != LIBDEFLATE_SUCCESS || used != deflated.size()) return std::nullopt;
  return raw;
}

std::uint32_t crc32Of(std::string_view bytes) { return libdeflate_crc32(0, bytes.data(), bytes.size()); }

}  // namespace fulbito
