#pragma once

#include <string>
#include <vector>

#include "replays/recording_reader.hpp"

namespace fulbito {

/// What can still be read of a damaged or cut file.
struct Salvage {
  RecordingHeader header;
  bool whole = false;                 ///< nothing is wrong with it
  std::vector<RecordedChunk> chunks;  ///< in order; those between were lost
  std::size_t lost_bytes = 0;         ///< that belong to nothing that can be read
  std::optional<RecordingResult> result;
};

/// Reads all chunks whose checksums hold, wherever the damage is. Errors: kIo; kBadInput when the header is
/// damaged, without which nothing has a meaning.
Result<Salvage> salvage(const std::string& file);
/// The same from bytes in memory; `origin` stands for the file's name in errors.
Result<Salvage> salvage(std::string bytes, const std::string& origin);

}  // namespace fulbito
