#pragma once

#include <span>
#include <string>
#include <string_view>

#include "experiments/papers/transport/transport_task.hpp"

namespace fulbito {

/// Reads a task from text in the form of the paper's Table 2, with lengths in cm and angles in degrees. A row
/// has a word and numbers; '#' begins a comment:
///
///     rod LENGTH            between the robots' centres
///     speed V, max-speed V  cm/s of the master, and of either robot (8 and 10)
///     lead X Y              where the leading robot starts: on the path, a rod's length from the follower
///     follower X Y          where the following robot starts (the path's beginning)
///     line X Y SLOPE [LENGTH]  a line from (X, Y); without a length, to where the next part begins
///     arc X Y ANGLE         an arc about (X, Y) by ANGLE, positive: to the left; the radius is the distance
///                           from (X, Y) to the end of the part before
///     start X Y             where the path begins, if its first part is an arc
///     end X Y               where the last part ends, if it is a line
///     point X Y             a vertex of a polyline, in place of lines and arcs; `fitPath` finds these
///     tolerance LENGTH      of that fit (0.5)
///
/// The rows of `line` and `arc` (or `point`) are in the order of the path; other rows may be anywhere. A line
/// without a length ends at the foot of the perpendicular from the next arc's centre, so Table 2 needs no
/// radii. Errors: kBadInput as `origin:line: ...`.
Result<TransportTask> parseTransport(std::string_view text, const std::string& origin);

/// Reads such a file. Errors: kIo, and as `parseTransport`.
Result<TransportTask> loadTransport(const std::string& file);

/// The task as text. `parseTransport` reads it with an accuracy of a micrometre.
std::string toText(const TransportTask& task);

/// A built-in task: "s-path" (Fig. 8 and Table 2) or "maze" (43 parts, as Fig. 10).
TransportTask builtInTransport(std::string_view name);

/// A path file that is embedded in the program.
struct PathText {
  std::string_view folder;
  std::string_view name;
  std::string_view text;
  std::string_view file;  ///< name with its ending
};

/// All files of experiments/papers/transport/paths.
std::span<const PathText> embeddedPaths();

}  // namespace fulbito
