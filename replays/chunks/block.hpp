#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fulbito/recording.hpp"
#include "replays/coding/byte_io.hpp"

/// A file consists of its magic number and version, then blocks. A block is a checksum (8 bytes), a type and
/// a size (4 bytes each), then its content. The checksum covers all bytes of the block after it.
namespace fulbito {

/// Like that of a PNG file: it does not look like text, and any conversion of line ends breaks it.
inline constexpr BytesView kMagic{
    "\x89"
    "FBR\r\n\x1a\n",
    8};
inline constexpr BytesView kEndMagic{"FBR.END\n", 8};
inline constexpr std::size_t kPrologueSize = 12;  ///< magic and version
inline constexpr std::size_t kBlockHeadSize = 16;
inline constexpr std::size_t kFooterSize = 24;  ///< offset of the index, checksum of the index, end magic

inline constexpr std::size_t kMaxBlockBytes = std::size_t{64} << 20;
/// Largest unpacked size of a header, a result or an index [bytes].
inline constexpr std::size_t kMaxTextBytes = std::size_t{8} << 20;

constexpr std::uint32_t blockName(const char (&name)[5]) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(name[i])} << (8 * i);
  return value;
}

/// Types of blocks. In a file, each number reads as four letters.
enum class BlockType : std::uint32_t {
  kHeader = blockName("HEAD"),
  kChunk = blockName("CHNK"),
  kResult = blockName("RSLT"),
  kIndex = blockName("INDX"),
};

/// A block in a file. Its size has been checked against the rest of the file.
struct Block {
  BlockType type{};
  std::size_t offset = 0;  ///< offset of the block's first byte in the file
  std::uint64_t checksum = 0;
  BytesView payload;
  std::size_t end() const { return offset + kBlockHeadSize + payload.size(); }
};

/// Seed of the header's checksum. It depends on the version, so a header of another version is rejected.
inline constexpr std::uint64_t kHeaderSeed = kRecordingVersion;
/// Seed of the checksum of block `number`. A block in another position or from another file is rejected.
std::uint64_t blockSeed(std::uint64_t header_checksum, std::uint64_t number);

/// Appends a block to `out`; returns its checksum.
std::uint64_t appendBlock(BlockType type, BytesView payload, std::uint64_t seed, Bytes& out);

/// Flaws of the next block of a file.
enum class BlockFlaw : std::uint8_t { kCut, kDamaged };
/// The block at `offset`.
tl::expected<Block, BlockFlaw> blockAt(BytesView file, std::size_t offset, std::uint64_t seed);

/// The position of a chunk, as stored in the index.
struct ChunkPlace {
  std::uint64_t offset = 0;
  std::uint64_t first_tick = 0;
  std::uint64_t ticks = 0;
  friend bool operator==(const ChunkPlace&, const ChunkPlace&) = default;
};

Bytes indexBytes(std::span<const ChunkPlace> chunks);
std::optional<std::vector<ChunkPlace>> readIndex(BytesView bytes);
/// The last bytes of a complete file.
Bytes footerBytes(std::uint64_t index_offset, std::uint64_t index_checksum);

}  // namespace fulbito
