#include "engine/core/math/random.hpp"
#include "replays/chunks/block.hpp"
#include "replays/chunks/chunk.hpp"
#include "replays/header/header_json.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/replays/sample_recording.hpp"

namespace fulbito {
namespace {

using test::sample;
using test::Told;

/// Reads all chunks. Returns whether that worked.
bool readsWhole(const RecordingReader& reader) {
  for (std::size_t i = 0; i < reader.chunkCount(); ++i) {
    if (!reader.chunk(i)) return false;
  }
  return true;
}

/// The blocks of the sample: header, chunks and others, with their payloads.
std::vector<Block> blocksOf(const std::string& bytes) {
  std::vector<Block> blocks;
  std::size_t at = kPrologueSize;
  std::uint64_t header = 0;
  while (at + kFooterSize < bytes.size()) {
    const auto block = blockAt(bytes, at, blocks.empty() ? kHeaderSeed : blockSeed(header, blocks.size()));
    REQUIRE(block);
    if (blocks.empty()) header = block->checksum;
    blocks.push_back(*block);
    at = block->end();
  }
  return blocks;
}

}  // namespace

TEST_CASE("a recording that was cut anywhere reads up to its last whole chunk", "[unit]") {
  const Told told = sample();
  const std::vector<Block> blocks = blocksOf(told.bytes);
  const std::size_t header_end = blocks.front().end();
  Tick last = 0;
  for (std::size_t size = 0; size < told.bytes.size(); ++size) {
    const auto reader = RecordingReader::parse(told.bytes.substr(0, size), "cut");
    REQUIRE(reader.has_value() == (size >= header_end));
    if (!reader) {
      REQUIRE(reader.error().code == ErrorCode::kBadInput);
      continue;
    }
    REQUIRE_FALSE(reader->finished());
    REQUIRE(readsWhole(*reader));
    REQUIRE(reader->ticks() >= last);
    last = reader->ticks();
    Tick expected = 0;
    for (std::size_t i = 1; i < blocks.size(); ++i) {
      if (blocks[i].type == BlockType::kChunk && blocks[i].end() <= size)
        expected = i == 4 ? 70 : 20 * Tick(i);
    }
    REQUIRE(reader->ticks() == expected);
  }
  CHECK(last == 70);
}

TEST_CASE("every flipped bit of a finished recording is noticed", "[unit]") {
  Told told = sample(45);
  for (std::size_t bit = 0; bit < 8 * told.bytes.size(); ++bit) {
    std::string bytes = told.bytes;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << (bit % 8)));
    const auto strict = RecordingReader::parse(bytes, "flipped");
    REQUIRE((!strict || !strict->finished()));
    if (!strict) REQUIRE(strict.error().code == ErrorCode::kBadInput);
    const auto salvaged = RecordingReader::parse(std::move(bytes), "flipped", {true});
    if (salvaged) {
      REQUIRE_FALSE(salvaged->finished());
      REQUIRE(readsWhole(*salvaged));
    }
  }
}

TEST_CASE("errors name the file and the place", "[unit]") {
  const Told told = sample();
  const auto messageOf = [](std::string bytes) {
    return RecordingReader::parse(std::move(bytes), "game.fbr").error().message;
  };
  CHECK(messageOf("") == "game.fbr: not a recording (.fbr) of this program");
  std::string other = told.bytes;
  for (const char format : {'\0', '\1', '\5'}) {
    other[kMagic.size()] = format;
    CHECK(messageOf(other) ==
          "game.fbr: a recording of format " + std::to_string(int{format}) + "; this program reads format 2");
  }
  const Block chunk = blocksOf(told.bytes)[2];
  std::string damaged = told.bytes;
  damaged[chunk.offset + 40] ^= 1;
  CHECK(messageOf(damaged) ==
        "game.fbr: damaged at byte " + std::to_string(chunk.offset) + ", after 2 good blocks");
  std::string doubled = told.bytes;
  doubled.insert(chunk.offset, told.bytes, chunk.offset, chunk.end() - chunk.offset);
  CHECK_FALSE(RecordingReader::parse(doubled, "game.fbr"));
  std::string missing = told.bytes;
  missing.erase(chunk.offset, chunk.end() - chunk.offset);
  CHECK_FALSE(RecordingReader::parse(missing, "game.fbr"));
}

TEST_CASE("a chunk with any content and a right checksum gives values or an error", "[unit]") {
  const Told told = sample();
  const RecordingHeader header = told.header;
  Rng rng(11, test::kTestStream);
  int refused = 0;
  for (const Block& block : blocksOf(told.bytes)) {
    if (block.type != BlockType::kChunk) continue;
    REQUIRE(readChunk(block.payload, header));
    for (std::size_t bit = 0; bit < 8 * block.payload.size(); ++bit) {
      std::string payload(block.payload);
      payload[bit / 8] = static_cast<char>(payload[bit / 8] ^ (1 << (bit % 8)));
      refused += readChunk(payload, header) ? 0 : 1;
    }
    for (int trial = 0; trial < 2000; ++trial) {
      std::string payload(
          block.payload.substr(0, rng.below(static_cast<std::uint32_t>(block.payload.size()))));
      for (std::uint32_t i = rng.below(8); i > 0 && !payload.empty(); --i) {
        payload[rng.below(static_cast<std::uint32_t>(payload.size()))] = static_cast<char>(rng.bits32());
      }
      refused += readChunk(payload, header) ? 0 : 1;
    }
  }
  CHECK(refused > 8000);
}

TEST_CASE("a header or result with any content gives values or an error", "[unit]") {
  const std::string header = toJson(test::sampleHeader()), result = toJson(RecordingResult{});
  REQUIRE(headerFromJson(header));
  REQUIRE(resultFromJson(result));
  int refused = 0;
  for (std::size_t bit = 0; bit < 8 * header.size(); ++bit) {
    std::string text = header;
    text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << (bit % 8)));
    refused += headerFromJson(text) ? 0 : 1;
  }
  CHECK(refused > 1000);
  for (std::size_t bit = 0; bit < 8 * result.size(); ++bit) {
    std::string text = result;
    text[bit / 8] = static_cast<char>(text[bit / 8] ^ (1 << (bit % 8)));
    (void)resultFromJson(text);
  }
  CHECK_FALSE(headerFromJson("[]"));
  CHECK_FALSE(headerFromJson(std::string(100000, '[')));
  CHECK(headerFromJson("{}").error() == "kind is missing");
}

TEST_CASE("what would take much memory is refused before it does", "[unit]") {
  RecordingHeader header = test::sampleHeader();
  header.chunk_ticks = 6000;
  header.bodies.assign(1000, {BodyKind::kObstacle, {}});
  CHECK(flawOf(header));
  const Told told = sample();
  std::string bytes = told.bytes;
  // A block with a claimed size of 4 GiB.
  bytes.replace(kPrologueSize + 16, 8, 8, '\xff');
  const auto reader = RecordingReader::parse(bytes, "huge");
  REQUIRE_FALSE(reader);
  CHECK(reader.error().message == "huge: its header is damaged");
}

}  // namespace fulbito
