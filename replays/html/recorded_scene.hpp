#pragma once

#include "fulbito/detail/page_scene.hpp"
#include "fulbito/detail/values.hpp"
#include "fulbito/recording.hpp"

namespace fulbito {

/// Converts a recording of level full for the HTML viewer, with about 30 rows and ten commands per second.
/// `timeline` belongs to `recording`. Errors: kBadInput for an unreadable field, robot or layout in the
/// recipe; as `RecordingReader::chunk`.
Result<PageScene> recordedScene(const RecordingReader& recording, const ReplayTimeline& timeline);

}  // namespace fulbito
