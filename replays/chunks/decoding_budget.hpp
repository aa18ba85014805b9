#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "replays/chunks/chunk.hpp"

namespace fulbito {

/// How much a recording may unpack to, by its size: a small file must not fill the memory. A tick that was
/// really played takes two bytes for its hash alone, whatever the bodies do, and a play some hundred; lists
/// are packed to a tenth at best. Calls of the referee come with plays, drawings with ticks. The limits lie
/// ten times and more above that, and bound what is made of a recording too, such as a page.
class DecodingBudget {
 public:
  explicit DecodingBudget(std::size_t file_bytes);
  /// Takes what a chunk will need; gives what there is too much of, if anything.
  std::optional<std::string> take(const ChunkHead& head, BytesView payload, const RecordingHeader& header);

 private:
  std::uint64_t rows_;        ///< bodies times ticks that are left
  std::uint64_t starts_;      ///< bodies times plays
  std::uint64_t list_bytes_;  ///< of plays, events and drawings, unpacked
  std::uint64_t plays_, events_, drawings_;
};

}  // namespace fulbito
