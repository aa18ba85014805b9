#include "replays/recording_salvage.hpp"

#include "replays/chunks/block.hpp"
#include "replays/chunks/chunk.hpp"
#include "replays/chunks/decoding_budget.hpp"
#include "replays/header/header_json.hpp"

namespace fulbito {
namespace {

/// Most consecutive blocks that may be lost if the next block is still to be recognised by its number.
constexpr std::uint64_t kMostLost = 4096;
/// Offset of the type in a block [bytes].
constexpr std::size_t kTypeOffset = 8;

/// The next intact block at or after `offset`, and its number.
struct Found {
  Block block;
  std::uint64_t number = 0;
};

bool knownType(BytesView file, std::size_t offset) {
  if (file.size() - offset < kBlockHeadSize) return false;
  ByteReader in(file.substr(offset + kTypeOffset));
  const auto type = static_cast<BlockType>(in.fixed<std::uint32_t>());
  return type == BlockType::kChunk || type == BlockType::kResult;
}

std::optional<Found> nextBlock(BytesView file, std::size_t offset, std::uint64_t header,
                               std::uint64_t number) {
  if (const auto block = blockAt(file, offset, blockSeed(header, number))) return Found{*block, number};
  for (std::size_t at = offset; at < file.size(); ++at) {
    if (!knownType(file, at)) continue;
    for (std::uint64_t n = number; n <= number + kMostLost; ++n) {
      const auto block = blockAt(file, at, blockSeed(header, n));
      if (block) return Found{*block, n};
      if (block.error() == BlockFlaw::kCut) break;
    }
  }
  return std::nullopt;
}

Result<Salvage> salvaged(const Result<RecordingReader>& reader) {
  if (!reader) return tl::unexpected<Error>(reader.error());
  Salvage found;
  found.header = reader->header();
  found.whole = reader->finished();
  const BytesView bytes = reader->bytes();
  const auto head = blockAt(bytes, kPrologueSize, kHeaderSeed);
  if (!head) return fail(ErrorCode::kBadInput, reader->origin() + ": its header is damaged");
  DecodingBudget budget(bytes.size());
  std::size_t next = head->end(), known = next;
  for (std::uint64_t number = 1; const auto block = nextBlock(bytes, next, head->checksum, number);) {
    next = block->block.end();
    number = block->number + 1;
    known += kBlockHeadSize + block->block.payload.size();
    if (block->block.type == BlockType::kChunk) {
      const auto first = readChunkHead(block->block.payload, found.header);
      const auto flaw = first ? budget.take(*first, block->block.payload, found.header) : std::nullopt;
      if (flaw) return fail(ErrorCode::kBadInput, reader->origin() + ": " + *flaw);
      auto chunk = readChunk(block->block.payload, found.header);
      if (chunk) found.chunks.push_back(std::move(*chunk));
    } else if (block->block.type == BlockType::kResult) {
      const auto text = unpacked(block->block.payload, kMaxTextBytes);
      auto result = text ? resultFromJson(*text) : tl::unexpected<std::string>("");
      if (result) found.result = std::move(*result);
    } else {
      break;
    }
  }
  found.lost_bytes = found.whole ? 0 : bytes.size() - known;
  return found;
}

}  // namespace

Result<Salvage> salvage(const std::string& file) { return salvaged(RecordingReader::open(file, {true})); }

Result<Salvage> salvage(std::string bytes, const std::string& origin) {
  return salvaged(RecordingReader::parse(std::move(bytes), origin, {true}));
}

}  // namespace fulbito
