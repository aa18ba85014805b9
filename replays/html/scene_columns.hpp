#pragma once

#include <string>

#include "fulbito/detail/page_scene.hpp"

namespace fulbito {

/// The values of a scene as signed varints, column by column: tick of each row; x, y and (if not round)
/// heading of each body; left and right command of each robot; then the drawings, field by field. Each value
/// is stored as the difference from the linear extrapolation of the last two, which restarts at each play.
std::string packedColumns(const PageScene& scene);

/// Whether the page stores the body's heading.
bool hasHeading(const PageBody& body);

}  // namespace fulbito
