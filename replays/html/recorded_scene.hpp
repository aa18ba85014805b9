#pragma once

#include "engine/core/base/result.hpp"
#include "replays/html/page_scene.hpp"
#include "replays/recording_reader.hpp"
#include "replays/timeline.hpp"

namespace fulbito {

/// A recording of level full for the HTML viewer: a row about 30 times a second, commands ten times a second.
/// `timeline` is of `recording`. Errors: kBadInput for a recipe whose field, robot or layout cannot be read;
/// as RecordingReader::chunk.
Result<PageScene> recordedScene(const RecordingReader& recording, const ReplayTimeline& timeline);

}  // namespace fulbito
