#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "replays/chunks/chunk.hpp"

namespace fulbito {

/// Limits the unpacked size of a recording by its file size, so that a small file cannot fill the memory. A
/// simulated tick takes at least two bytes, for its hash, and a play about a hundred; lists shrink to a tenth
/// at best. Calls of the referee come with plays, drawings with ticks. The limits are at least ten times
/// higher than these numbers allow. They also bound what is made from a recording, such as a page.
class DecodingBudget {
 public:
  explicit DecodingBudget(std::size_t file_bytes);
  /// Subtracts what a chunk needs from the budget. Returns an error message if too little is left.
  std::optional<std::string> take(const ChunkHead& head, BytesView payload, const RecordingHeader& header);

 private:
  std::uint64_t rows_;        ///< remaining rows: bodies times ticks
  std::uint64_t starts_;      ///< remaining bodies times plays
  std::uint64_t list_bytes_;  ///< remaining unpacked bytes of plays, events and drawings
  std::uint64_t plays_, events_, drawings_;
};

}  // namespace fulbito
