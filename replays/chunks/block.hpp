#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "fulbito/recording.hpp"
#include "replays/coding/byte_io.hpp"

/// A file is its magic number and version, then blocks. A block is a checksum (8 bytes), type and size (4
/// each), then its content; the checksum covers all that follows it in the block.
namespace fulbito {

/// As in a PNG file: not text, and broken by any change of line ends.
inline constexpr BytesView kMagic{
    "\x89"
    "FBR\r\n\x1a\n",
    8};
inline constexpr BytesView kEndMagic{"FBR.END\n", 8};
inline constexpr std::size_t kPrologueSize = 12;  ///< magic and version
inline constexpr std::size_t kBlockHeadSize = 16;
inline constexpr std::size_t kFooterSize = 24;  ///< place of the index, its checksum, end magic

inline constexpr std::size_t kMaxBlockBytes = std::size_t{64} << 20;
/// The most that a header, a result or an index may unpack to.
inline constexpr std::size_t kMaxTextBytes = std::size_t{8} << 20;

constexpr std::uint32_t blockName(const char (&name)[5]) {
  std::uint32_t value = 0;
  for (int i = 0; i < 4; ++i) value |= std::uint32_t{static_cast<unsigned char>(name[i])} << (8 * i);
  return value;
}

/// What a block is; the numbers read as four letters in a file.
enum class BlockType : std::uint32_t {
  kHeader = blockName("HEAD"),
  kChunk = blockName("CHNK"),
  kResult = blockName("RSLT"),
  kIndex = blockName("INDX"),
};

/// A block as it lies in a file, its size checked against what is left.
struct Block {
  BlockType type{};
  std::size_t offset = 0;  ///< of its first byte in the file
  std::uint64_t checksum = 0;
  BytesView payload;
  std::size_t end() const { return offset + kBlockHeadSize + payload.size(); }
};

/// The seed of the header's checksum: a header of another format is none of this one.
inline constexpr std::uint64_t kHeaderSeed = kRecordingVersion;
/// The seed of any other block's checksum: no block can stand in another's place or come from another file.
std::uint64_t blockSeed(std::uint64_t header_checksum, std::uint64_t number);

/// Appends a block to `out`; returns its checksum.
std::uint64_t appendBlock(BlockType type, BytesView payload, std::uint64_t seed, Bytes& out);

/// What may be wrong with the next block of a file.
enum class BlockFlaw : std::uint8_t { kCut, kDamaged };
/// The block at `offset`.
tl::expected<Block, BlockFlaw> blockAt(BytesView file, std::size_t offset, std::uint64_t seed);

/// Where a chunk is, for the index.
struct ChunkPlace {
  std::uint64_t offset = 0;
  std::uint64_t first_tick = 0;
  std::uint64_t ticks = 0;
  friend bool operator==(const ChunkPlace&, const ChunkPlace&) = default;
};

Bytes indexBytes(std::span<const ChunkPlace> chunks);
std::optional<std::vector<ChunkPlace>> readIndex(BytesView bytes);
/// The last bytes of a finished file.
Bytes footerBytes(std::uint64_t index_offset, std::uint64_t index_checksum);

}  // namespace fulbito
