#include "replays/recording_writer.hpp"

#include <cerrno>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

#include <fmt/format.h>

#include "replays/block.hpp"
#include "replays/chunk.hpp"
#include "replays/header_json.hpp"

namespace fulbito {
namespace {

tl::unexpected<Error> cannotWrite(const std::string& file, int reason) {
  return fail(ErrorCode::kIo,
              fmt::format("cannot write '{}': {}", file, std::generic_category().message(reason)));
}

/// A file that is written from front to back.
class OutputStream {
 public:
  OutputStream(std::string name, int descriptor) : name_(std::move(name)), descriptor_(descriptor) {}
  OutputStream(const OutputStream&) = delete;
  OutputStream& operator=(const OutputStream&) = delete;
  ~OutputStream() { ::close(descriptor_); }

  Result<void> append(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) return cannotWrite(name_, errno);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return {};
  }

 private:
  const std::string name_;
  const int descriptor_;
};

/// What came from a file of version 1 is written in this version's steps.
RecordingHeader inThisVersion(RecordingHeader header) {
  if (header.sample_turn > 0) return header;
  header.sample_step = RecordingHeader().sample_step;
  header.sample_turn = RecordingHeader().sample_turn;
  return header;
}

}  // namespace

struct RecordingWriter::Impl {
  Impl(Sink to, const RecordingHeader& h) : sink(std::move(to)), header(inThisVersion(h)), chunk(header) {}

  void write(BytesView bytes) {
    if (state) state = sink(bytes);
    written += bytes.size();
  }
  std::uint64_t writeBlock(BlockType type, Codec codec, std::size_t raw_size, BytesView content) {
    block.clear();
    const std::uint64_t seed =
        blocks == 0 ? headerSeed(kRecordingVersion) : blockSeed(header_checksum, blocks);
    const std::uint64_t checksum = appendBlock(type, codec, raw_size, content, seed, block);
    if (blocks++ == 0) header_checksum = checksum;
    write(block);
    return checksum;
  }
  std::uint64_t writePacked(BlockType type, BytesView raw) {
    Bytes packed;
    const Codec codec = compressor.append({&raw, 1}, packed);
    return writeBlock(type, codec, raw.size(), packed);
  }
  void writeHead() {
    Bytes prologue(kMagic);
    ByteWriter(prologue).fixed(kRecordingVersion);
    write(prologue);
    writePacked(BlockType::kHeader, toJson(header));
  }
  void writeChunk() {
    if (chunk.empty()) return;
    const auto first = static_cast<std::uint64_t>(chunk.endTick() - chunk.ticks());
    places.push_back({written, first, static_cast<std::uint64_t>(chunk.ticks())});
    payload.clear();
    chunk.pack(compressor, payload);
    writeBlock(BlockType::kChunk, Codec::kStored, payload.size(), payload);
  }

  Sink sink;
  Result<void> state;  ///< the first error
  const RecordingHeader header;
  ChunkBuilder chunk;
  Compressor compressor;
  std::vector<ChunkPlace> places;
  Bytes payload, block;
  std::uint64_t header_checksum = 0, blocks = 0, written = 0;
  bool finished = false;
};

RecordingWriter::RecordingWriter(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RecordingWriter::RecordingWriter(RecordingWriter&&) noexcept = default;
RecordingWriter& RecordingWriter::operator=(RecordingWriter&&) noexcept = default;
RecordingWriter::~RecordingWriter() = default;

Result<RecordingWriter> RecordingWriter::create(Sink sink, const RecordingHeader& header) {
  if (const auto flaw = flawOf(header)) {
    return fail(ErrorCode::kUsage, "cannot record this: " + *flaw);
  }
  auto impl = std::make_unique<Impl>(std::move(sink), header);
  impl->writeHead();
  if (!impl->state) return tl::unexpected<Error>(impl->state.error());
  return RecordingWriter(std::move(impl));
}

Result<RecordingWriter> RecordingWriter::create(const std::string& file, const RecordingHeader& header) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
  if (descriptor < 0) return cannotWrite(file, errno);
  const auto stream = std::make_shared<OutputStream>(file, descriptor);
  return create([stream](std::string_view bytes) { return stream->append(bytes); }, header);
}

const RecordingHeader& RecordingWriter::header() const { return impl_->header; }
Tick RecordingWriter::tick() const { return impl_->chunk.endTick(); }

void RecordingWriter::beginPlay(const RecordedPlay& play) {
  if (impl_->finished || play.starts.size() != impl_->header.bodies.size()) return;
  if (impl_->chunk.full()) impl_->writeChunk();
  impl_->chunk.play(play, impl_->chunk.endTick());
}

void RecordingWriter::add(const RecordingTick& tick) {
  if (impl_->finished) return;
  if (impl_->chunk.full()) impl_->writeChunk();
  impl_->chunk.tick({impl_->chunk.endTick() + 1, tick.world, tick.commands, tick.hash, tick.playing});
}

void RecordingWriter::add(const RecordedEvent& event) {
  if (!impl_->finished) impl_->chunk.event(event);
}

void RecordingWriter::add(const RecordedDrawing& drawing) {
  if (!impl_->finished && impl_->header.level == RecordingLevel::kFull) impl_->chunk.drawing(drawing);
}

Result<void> RecordingWriter::finish(const RecordingResult& result) {
  Impl& w = *impl_;
  if (w.finished) return w.state;
  w.finished = true;
  w.writeChunk();
  RecordingResult whole = result;
  whole.ticks = w.chunk.endTick();
  w.writePacked(BlockType::kResult, toJson(whole));
  const std::uint64_t index_offset = w.written;
  const std::uint64_t checksum = w.writePacked(BlockType::kIndex, indexBytes(w.places));
  w.write(footerBytes(index_offset, checksum));
  w.sink = nullptr;  // closes the file
  return w.state;
}

}  // namespace fulbito
