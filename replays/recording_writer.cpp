#include <optional>

#include "engine/core/system/output_file.hpp"
#include "fulbito/recording.hpp"
#include "replays/chunks/block.hpp"
#include "replays/chunks/chunk.hpp"
#include "replays/header/header_json.hpp"

namespace fulbito {
struct RecordingWriter::Impl {
  Impl(Sink to, const RecordingHeader& h) : sink(std::move(to)), header(h), chunk(header) {}

  void write(BytesView bytes) {
    if (state) state = sink(bytes);
    written += bytes.size();
  }
  std::uint64_t writeBlock(BlockType type, BytesView content) {
    block.clear();
    const std::uint64_t seed = blocks == 0 ? kHeaderSeed : blockSeed(header_checksum, blocks);
    const std::uint64_t checksum = appendBlock(type, content, seed, block);
    if (blocks++ == 0) header_checksum = checksum;
    write(block);
    return checksum;
  }
  std::uint64_t writePacked(BlockType type, BytesView raw) {
    Bytes packed;
    packer.pack(raw, packed);
    return writeBlock(type, packed);
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
    const ChunkPlace place{written, first, static_cast<std::uint64_t>(chunk.ticks())};
    payload.clear();
    chunk.pack(packer, payload);
    writeBlock(BlockType::kChunk, payload);
    if (state) places.push_back(place);
  }

  /// Completes the file, or drops it: a file without a whole chunk cannot be read.
  void endFile() {
    if (!file) return;
    if (state) {
      state = file->commit();
    } else if (places.empty()) {
      file->discard();
    } else {
      // A growing file keeps its content; a file to replace another one is removed, and the old one stays.
      (void)file->commit();
    }
  }

  std::shared_ptr<OutputFile> file;  ///< null: the sink belongs to the caller
  Sink sink;
  Result<void> state;  ///< the first error, if any
  const RecordingHeader header;
  ChunkBuilder chunk;
  const Packer packer{Packer::kFast};
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

Result<RecordingWriter> RecordingWriter::create(const std::string& file, const RecordingHeader& header,
                                                bool replace) {
  if (file == "-") return fail(ErrorCode::kUsage, "'-': a recording goes to a file, not to stdout");
  auto opened = OutputFile::grow(file, replace);
  if (!opened) return tl::unexpected<Error>(opened.error());
  const auto out = std::make_shared<OutputFile>(std::move(*opened));
  auto writer = create([out](std::string_view bytes) { return out->write(bytes); }, header);
  if (writer) {
    writer->impl_->file = out;
  } else {
    out->discard();
  }
  return writer;
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
  w.endFile();
  return w.state;
}

}  // namespace fulbito
