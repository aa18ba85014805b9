#pragma once

#include <string>
#include <vector>

#include "fulbito/recording.hpp"

namespace fulbito {

/// The readable parts of a damaged or cut file.
struct Salvage {
  RecordingHeader header;
  bool whole = false;                 ///< the file is undamaged
  std::vector<RecordedChunk> chunks;  ///< in order, possibly with gaps
  std::size_t lost_bytes = 0;         ///< number of unreadable bytes
  std::optional<RecordingResult> result;
};

/// Reads all chunks with valid checksums, before and after the damage. Errors: kIo; kBadInput if the header
/// is damaged, since nothing can be read without it.
Result<Salvage> salvage(const std::string& file);
/// As `salvage`, but from bytes in memory; `origin` stands for the file's name in errors.
Result<Salvage> salvage(std::string bytes, const std::string& origin);

}  // namespace fulbito
