#pragma once

#include <functional>
#include <string>

#include "fulbito/recording.hpp"

namespace fulbito {

/// Receives a table's text piece by piece.
using TableSink = std::function<void(const std::string&)>;

/// CSV with one line per sampled tick from `from` to `to` [s]: time, clock, score and every body's pose,
/// empty if it is not on the field. The first line names the columns. Lengths are in metres, angles in
/// radians.
void writeCsv(const ReplayTimeline& timeline, double from, double to, const TableSink& sink);

/// The same data as one JSON object per line with a `type`: first `recording`, then `play`, `event` and
/// `state` in order of time.
void writeJsonLines(const ReplayTimeline& timeline, double from, double to, const TableSink& sink);

}  // namespace fulbito
