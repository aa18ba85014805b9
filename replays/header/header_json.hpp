#pragma once

#include <optional>

#include "fulbito/detail/values.hpp"
#include "fulbito/recording.hpp"
#include "replays/coding/byte_io.hpp"

namespace fulbito {

/// @{ Limits on the memory that a broken file can request.
inline constexpr std::size_t kMaxRecordedBodies = 1024;
inline constexpr int kMaxChunkTicks = 6000;
inline constexpr std::size_t kMaxChunkRows = std::size_t{1} << 20;  ///< bodies times ticks of a chunk
inline constexpr std::int64_t kMaxChunkPlays = 256;
/// @}

/// A description of what makes a header invalid; empty for a valid one.
std::optional<std::string> flawOf(const RecordingHeader& header);

std::string toJson(const RecordingHeader& header);
std::string toJson(const RecordingResult& result);
/// @{ Errors describe what is wrong, without the file's name. Unknown keys are ignored.
tl::expected<RecordingHeader, std::string> headerFromJson(BytesView text);
tl::expected<RecordingResult, std::string> resultFromJson(BytesView text);
/// @}

}  // namespace fulbito
