#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/base/result.hpp"
#include "replays/recording/recording.hpp"

namespace fulbito {

/// Options of a reader.
struct RecordingReadOptions {
  bool salvage = false;  ///< read a damaged file up to the damage, as if it were cut off there
};

/// The stored bytes of one kind of content.
struct RecordingPart {
  std::string name;
  std::size_t bytes = 0;
};

/// Reads a recording. Opening checks all checksums and the order of chunks. Chunks are unpacked on request.
class RecordingReader {
 public:
  /// Errors: kIo; kBadInput naming the file, the block and its place, for what is no recording, of another
  /// format, or damaged. A file that was cut is no error: see `finished`.
  static Result<RecordingReader> open(const std::string& file, RecordingReadOptions options = {});
  /// The same from bytes in memory; `origin` stands for the file's name in errors.
  static Result<RecordingReader> parse(std::string bytes, const std::string& origin,
                                       RecordingReadOptions options = {});
  RecordingReader(RecordingReader&&) noexcept;
  RecordingReader& operator=(RecordingReader&&) noexcept;
  ~RecordingReader();

  const RecordingHeader& header() const;
  /// Whether the recording was finished; false: it is cut off, and its last seconds may be missing.
  bool finished() const;
  /// The result, if the recording was finished.
  const std::optional<RecordingResult>& result() const;
  /// Ticks in all chunks.
  Tick ticks() const;
  std::size_t chunkCount() const;
  /// A chunk, `index` below `chunkCount`. Errors: kBadInput.
  Result<RecordedChunk> chunk(std::size_t index) const;
  std::size_t sizeInBytes() const;
  /// Bytes per kind of content, and "frame" for the remaining structure.
  std::vector<RecordingPart> sizeByPart() const;
  /// The file's name, or its substitute in errors.
  const std::string& origin() const;
  /// The whole file.
  std::string_view bytes() const;

 private:
  struct Impl;
  explicit RecordingReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
