#pragma once

#include <functional>
#include <string>

#include "replays/timeline.hpp"

namespace fulbito {

/// Takes a table's text piece by piece.
using TableSink = std::function<void(const std::string&)>;

/// One line a sampled tick from `from` to `to` [s]: time, clock, score and every body's pose; empty where it
/// is not on the field. The first line names the columns; lengths are in metres, angles in radians.
void writeCsv(const ReplayTimeline& timeline, double from, double to, const TableSink& sink);

/// The same as one JSON object a line, `type` telling them apart: a `recording` first, then `play`, `event`
/// and `state` in the order of time.
void writeJsonLines(const ReplayTimeline& timeline, double from, double to, const TableSink& sink);

}  // namespace fulbito
