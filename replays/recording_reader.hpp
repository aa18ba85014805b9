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

/// How strict a reader is.
struct RecordingReadOptions {
  bool salvage = false;  ///< of a damaged file, what precedes the damage is read as if it were cut there
};

/// How many bytes of a file one kind of content takes, as stored.
struct RecordingPart {
  std::string name;
  std::size_t bytes = 0;
};

/// Reads a recording. All checksums and the order of chunks are checked when it is opened; a chunk is
/// unpacked when it is asked for.
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
  /// Whether the recording was finished; false: it was cut, and its last seconds may be missing.
  bool finished() const;
  /// Of a finished recording.
  const std::optional<RecordingResult>& result() const;
  /// Ticks in all chunks.
  Tick ticks() const;
  std::size_t chunkCount() const;
  /// A chunk, `index` below `chunkCount`. Errors: kBadInput.
  Result<RecordedChunk> chunk(std::size_t index) const;
  std::size_t sizeInBytes() const;
  /// Where the bytes go: every kind of content that is there, and "frame" for all that holds them together.
  std::vector<RecordingPart> sizeByPart() const;
  /// The file's name, or what stands for it in errors.
  const std::string& origin() const;
  /// The whole file.
  std::string_view bytes() const;

 private:
  struct Impl;
  explicit RecordingReader(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace fulbito
