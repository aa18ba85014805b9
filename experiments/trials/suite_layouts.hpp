#pragma once

#include <cstdint>

#include "fulbito/detail/layout.hpp"

namespace fulbito {

/// @{ Seeded layouts of the suites (docs/suites.md): layout `index` of `seed`, as a pure function of both.
/// Every layout is on the 1.5 x 1.3 m field, in centre coordinates.

/// Corner to corner past four tennis balls, two in the lower left and two in the upper right. At least two
/// are within 8.65 cm of the straight line. This is the setting of Jung & Lee (2015), section 5.
Layout cornerLayout(std::uint64_t seed, std::uint64_t index);
/// A distance of 0.55 to 0.75 m past the same balls.
Layout shortLayout(std::uint64_t seed, std::uint64_t index);
/// The corner layout shrunk about its middle to a distance of 0.58 to 0.72 m, which is the size that the
/// results of Jung & Lee (2015) imply (docs/papers.md). The balls have full size, and their centres are at
/// least 15 cm from start and goal.
Layout closeRangeLayout(std::uint64_t seed, std::uint64_t index);
/// The corner layout with a random initial heading and an arrival heading with a tolerance of 10 degrees.
Layout headingLayout(std::uint64_t seed, std::uint64_t index);
/// Four kinds in turn: a start that touches a wall and faces it, a start in a corner, a goal near a wall, and
/// a goal near an obstacle.
Layout wallsLayout(std::uint64_t seed, std::uint64_t index);
/// Two kinds in turn: a barrier of robot-sized obstacles with one gap, and scattered obstacles. The gap is
/// 1.1, 1.3 or 1.6 robot widths.
Layout clutter11Layout(std::uint64_t seed, std::uint64_t index);
Layout clutter13Layout(std::uint64_t seed, std::uint64_t index);
Layout clutter16Layout(std::uint64_t seed, std::uint64_t index);
/// A U of robot-sized obstacles that opens toward the start, with the goal behind it: a trap for methods that
/// plan no path.
Layout uTrapLayout(std::uint64_t seed, std::uint64_t index);
/// One to five robot-sized obstacles that cross the way at 0.3 to 1.5 m/s and bounce off the walls.
Layout movingLayout(std::uint64_t seed, std::uint64_t index);
/// The class of Fig. 8 of P.-G. Kim et al. (2006): a row of obstacles of different sizes across the way, with
/// one gap of `widths` robot widths near the straight line and wide ways round both ends.
Layout rowLayout(std::uint64_t seed, std::uint64_t index, double widths);
/// Three kinds in turn: a gap, scattered obstacles, and a row, with gaps of 1.1, 1.3 or 1.6 robot widths.
Layout sonar11Layout(std::uint64_t seed, std::uint64_t index);
Layout sonar13Layout(std::uint64_t seed, std::uint64_t index);
Layout sonar16Layout(std::uint64_t seed, std::uint64_t index);
/// @}

}  // namespace fulbito
