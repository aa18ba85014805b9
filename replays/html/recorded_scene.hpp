#pragma once

#include "engine/core/base/result.hpp"
#include "replays/html/page_scene.hpp"
#include "replays/recording_reader.hpp"
#include "replays/timeline.hpp"

namespace fulbito {

/// A recording of level full for the HTML viewer: about 30 rows and ten commands per second. `timeline`
/// belongs to `recording`. Errors: kBadInput for an unreadable field, robot or layout in the recipe; as
/// RecordingReader::chunk.
Result<PageScene> recordedScene(const RecordingReader& recording, const ReplayTimeline& timeline);

}  // namespace fulbito
