#include <array>

#include <fmt/format.h>

#include "engine/core/system/text_file.hpp"
#include "fulbito/recording.hpp"
#include "replays/chunks/block.hpp"
#include "replays/chunks/chunk.hpp"
#include "replays/chunks/decoding_budget.hpp"
#include "replays/header/header_json.hpp"

namespace fulbito {
namespace {

/// Largest file that is read [bytes]: 1 GiB, more than ten days of 3v3.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

std::string nameOf(BlockType type) {
  switch (type) {
    case BlockType::kHeader:
      return "header";
    case BlockType::kChunk:
      return "chunk";
    case BlockType::kResult:
      return "result";
    case BlockType::kIndex:
      return "index";
  }
  return "unknown block";
}

}  // namespace

struct RecordingReader::Impl {
  struct Place {
    ChunkPlace place;
    BytesView payload;
  };
  using Step = Result<void>;

  Impl(std::string content, std::string name)
      : bytes(std::move(content)), origin(std::move(name)), budget(bytes.size()) {}

  tl::unexpected<Error> bad(const std::string& what) const {
    return fail(ErrorCode::kBadInput, fmt::format("{}: {}", origin, what));
  }
  tl::unexpected<Error> badBlock(const Block& block, const std::string& what) const {
    return bad(fmt::format("the {} at byte {} is bad: {}", nameOf(block.type), block.offset, what));
  }

  Step readPrologue() {
    if (!BytesView(bytes).starts_with(kMagic)) return bad("not a recording (.fbr) of this program");
    ByteReader in(BytesView(bytes).substr(kMagic.size()));
    const auto version = in.fixed<std::uint32_t>();
    if (!in.good()) return bad("cut before its header");
    if (version != kRecordingVersion) {
      return bad(
          fmt::format("a recording of format {}; this program reads format {}", version, kRecordingVersion));
    }
    return {};
  }

  Step readHeader() {
    const auto block = blockAt(bytes, kPrologueSize, kHeaderSeed);
    if (!block) {
      return bad(block.error() == BlockFlaw::kCut ? "cut before the end of its header"
                                                  : "its header is damaged");
    }
    if (block->type != BlockType::kHeader) return badBlock(*block, "a header was expected");
    const auto text = unpacked(block->payload, kMaxTextBytes);
    if (!text) return badBlock(*block, "it cannot be unpacked");
    auto read = headerFromJson(*text);
    if (!read) return badBlock(*block, read.error());
    header = std::move(*read);
    header_checksum = block->checksum;
    header_bytes = block->payload.size();
    next = block->end();
    return {};
  }

  /// Reads all blocks after the header, up to the end of the file or the first flaw.
  Step readBlocks() {
    for (std::uint64_t number = 1; next < bytes.size(); ++number) {
      const auto block = blockAt(bytes, next, blockSeed(header_checksum, number));
      if (!block) {
        // A complete file ends with the end magic, so a block that seems cut in it is damaged.
        if (block.error() == BlockFlaw::kCut && !BytesView(bytes).ends_with(kEndMagic)) return {};
        return bad(fmt::format("damaged at byte {}, after {} good blocks", next, number));
      }
      if (auto taken = take(*block); !taken) return taken;
      next = block->end();
      if (block->type == BlockType::kIndex) return readFooter(*block);
    }
    return {};
  }

  Step take(const Block& block) {
    switch (block.type) {
      case BlockType::kChunk:
        return takeChunk(block);
      case BlockType::kResult:
        return takeResult(block);
      case BlockType::kIndex:
        return takeIndex(block);
      case BlockType::kHeader:
        break;
    }
    return badBlock(block, "it does not belong there");
  }

  Step takeChunk(const Block& block) {
    if (result) return badBlock(block, "it follows the result");
    const auto head = readChunkHead(block.payload, header);
    if (!head) return badBlock(block, head.error());
    if (head->first_tick != ticks || head->plays_before != plays) {
      return badBlock(block, "it does not follow the chunk before it");
    }
    if (const auto flaw = budget.take(*head, block.payload, header)) return badBlock(block, *flaw);
    ticks += head->ticks;
    plays += head->plays;
    chunks.push_back({{block.offset, static_cast<std::uint64_t>(head->first_tick),
                       static_cast<std::uint64_t>(head->ticks)},
                      block.payload});
    return {};
  }

  Step takeResult(const Block& block) {
    if (result) return badBlock(block, "there are two");
    const auto text = unpacked(block.payload, kMaxTextBytes);
    if (!text) return badBlock(block, "it cannot be unpacked");
    auto read = resultFromJson(*text);
    if (!read) return badBlock(block, read.error());
    if (read->ticks != ticks) return badBlock(block, "it counts other ticks than the chunks hold");
    result = std::move(*read);
    return {};
  }

  Step takeIndex(const Block& block) {
    if (!result) return badBlock(block, "there is no result before it");
    const auto text = unpacked(block.payload, kMaxTextBytes);
    const auto places = text ? readIndex(*text) : std::nullopt;
    bool same = places && places->size() == chunks.size();
    for (std::size_t i = 0; same && i < chunks.size(); ++i) same = (*places)[i] == chunks[i].place;
    if (!same) return badBlock(block, "it does not agree with the chunks");
    return {};
  }

  Step readFooter(const Block& index) {
    const BytesView left = BytesView(bytes).substr(next);
    const Bytes footer = footerBytes(index.offset, index.checksum);
    if (left.size() < footer.size() && BytesView(footer).starts_with(left)) return {};
    if (left != footer) return bad(fmt::format("damaged at byte {}, in its last bytes", next));
    finished = true;
    return {};
  }

  const std::string bytes;
  const std::string origin;
  DecodingBudget budget;
  RecordingHeader header;
  std::size_t header_bytes = 0;
  std::uint64_t header_checksum = 0;
  std::size_t next = 0;
  std::vector<Place> chunks;
  Tick ticks = 0;
  std::int64_t plays = 0;
  std::optional<RecordingResult> result;
  bool finished = false;
};

RecordingReader::RecordingReader(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RecordingReader::RecordingReader(RecordingReader&&) noexcept = default;
RecordingReader& RecordingReader::operator=(RecordingReader&&) noexcept = default;
RecordingReader::~RecordingReader() = default;

Result<RecordingReader> RecordingReader::open(const std::string& file, RecordingReadOptions options) {
  auto bytes = readTextFile(file, kMaxFileBytes, kMagic);
  if (!bytes) return tl::unexpected<Error>(bytes.error());
  return parse(std::move(*bytes), file, options);
}

Result<RecordingReader> RecordingReader::parse(std::string bytes, const std::string& origin,
                                               RecordingReadOptions options) {
  auto impl = std::make_unique<Impl>(std::move(bytes), origin);
  if (auto read = impl->readPrologue(); !read) return tl::unexpected<Error>(read.error());
  if (auto read = impl->readHeader(); !read) return tl::unexpected<Error>(read.error());
  if (auto read = impl->readBlocks(); !read && !options.salvage) return tl::unexpected<Error>(read.error());
  return RecordingReader(std::move(impl));
}

const RecordingHeader& RecordingReader::header() const { return impl_->header; }
bool RecordingReader::finished() const { return impl_->finished; }
const std::optional<RecordingResult>& RecordingReader::result() const { return impl_->result; }
Tick RecordingReader::ticks() const { return impl_->ticks; }
std::size_t RecordingReader::chunkCount() const { return impl_->chunks.size(); }
std::size_t RecordingReader::sizeInBytes() const { return impl_->bytes.size(); }

const std::string& RecordingReader::origin() const { return impl_->origin; }
std::string_view RecordingReader::bytes() const { return impl_->bytes; }

std::vector<RecordingPart> RecordingReader::sizeByPart() const {
  std::array<std::size_t, kSectionNames.size()> sizes{};
  for (const Impl::Place& chunk : impl_->chunks) {
    const auto sections = sectionsOf(chunk.payload, impl_->header);
    for (std::size_t i = 0; i < sizes.size(); ++i) sizes[i] += sections[i].size();
  }
  std::vector<RecordingPart> parts{{"header", impl_->header_bytes}};
  std::size_t known = impl_->header_bytes;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    known += sizes[i];
    if (sizes[i] > 0) parts.push_back({kSectionNames[i], sizes[i]});
  }
  parts.push_back({"frame", impl_->bytes.size() - known});
  return parts;
}

Result<RecordedChunk> RecordingReader::chunk(std::size_t index) const {
  auto read = readChunk(impl_->chunks[index].payload, impl_->header);
  if (!read) {
    return impl_->bad(
        fmt::format("the chunk at byte {} is bad: {}", impl_->chunks[index].place.offset, read.error()));
  }
  return std::move(*read);
}

}  // namespace fulbito
