#include "replays/chunks/block.hpp"

#define XXH_INLINE_ALL
#include <xxhash.h>

namespace fulbito {

std::uint64_t blockSeed(std::uint64_t header_checksum, std::uint64_t number) {
  return header_checksum + number;
}

std::uint64_t appendBlock(BlockType type, BytesView payload, std::uint64_t seed, Bytes& out) {
  const std::size_t begin = out.size();
  ByteWriter writer(out);
  writer.fixed(std::uint64_t{0});
  writer.fixed(static_cast<std::uint32_t>(type));
  writer.fixed(static_cast<std::uint32_t>(payload.size()));
  out.append(payload);
  const std::uint64_t checksum = XXH3_64bits_withSeed(out.data() + begin + 8, out.size() - begin - 8, seed);
  Bytes bytes;
  ByteWriter(bytes).fixed(checksum);
  out.replace(begin, bytes.size(), bytes);
  return checksum;
}

tl::expected<Block, BlockFlaw> blockAt(BytesView file, std::size_t offset, std::uint64_t seed) {
  if (offset > file.size() || file.size() - offset < kBlockHeadSize) return tl::unexpected(BlockFlaw::kCut);
  ByteReader reader(file.substr(offset));
  Block block;
  block.offset = offset;
  block.checksum = reader.fixed<std::uint64_t>();
  block.type = static_cast<BlockType>(reader.fixed<std::uint32_t>());
  const std::size_t size = reader.fixed<std::uint32_t>();
  if (size > kMaxBlockBytes) return tl::unexpected(BlockFlaw::kDamaged);
  if (size > reader.left()) return tl::unexpected(BlockFlaw::kCut);
  block.payload = reader.bytes(size);
  const BytesView covered = file.substr(offset + 8, kBlockHeadSize - 8 + size);
  if (XXH3_64bits_withSeed(covered.data(), covered.size(), seed) != block.checksum) {
    return tl::unexpected(BlockFlaw::kDamaged);
  }
  return block;
}

Bytes indexBytes(std::span<const ChunkPlace> chunks) {
  Bytes bytes;
  ByteWriter writer(bytes);
  writer.varint(chunks.size());
  for (const ChunkPlace& chunk : chunks) {
    writer.varint(chunk.offset);
    writer.varint(chunk.first_tick);
    writer.varint(chunk.ticks);
  }
  return bytes;
}

std::optional<std::vector<ChunkPlace>> readIndex(BytesView bytes) {
  ByteReader reader(bytes);
  std::vector<ChunkPlace> chunks(static_cast<std::size_t>(reader.varint(bytes.size() / 3)));
  for (ChunkPlace& chunk : chunks) chunk = {reader.varint(), reader.varint(), reader.varint()};
  if (!reader.good() || !reader.atEnd()) return std::nullopt;
  return chunks;
}

Bytes footerBytes(std::uint64_t index_offset, std::uint64_t index_checksum) {
  Bytes bytes;
  ByteWriter writer(bytes);
  writer.fixed(index_offset);
  writer.fixed(index_checksum);
  bytes.append(kEndMagic);
  return bytes;
}

}  // namespace fulbito
