#pragma once

#include <span>
#include <vector>

#include "fulbito/recording.hpp"

/// The states of recordings whose motion was heard from another program (`RecordingHeader::heard`).
namespace fulbito {

/// The pose as a sample of the recording keeps it.
Pose2 asSampled(const RecordingHeader& header, const Pose2& pose);

/// Puts bodies where they were heard, at rest, and counts the tick. So what a heard recording has of a state
/// is all that its hashes cover.
/// @param poses   one per body of the header, `asSampled`
/// @param bodies  header indices of those on the field, in the order of the header
void standAt(const RecordingHeader& header, const std::vector<Pose2>& poses,
             std::span<const std::size_t> bodies, WorldState& state);

}  // namespace fulbito
