// Private header of replays/html: not installed.
#pragma once

#include <string>

#include "replays/html/page_scene.hpp"

namespace fulbito {

/// The numbers of a scene as signed varints, column by column: tick of each row; x, y and (of what is not
/// round) heading of each body; left and right command of each robot; then the drawings, field by field.
/// Kept are differences from where the last two values point, which jumps of a play's start interrupt.
std::string packedColumns(const PageScene& scene);

/// Whether the page keeps a heading of the body.
bool hasHeading(const PageBody& body);

}  // namespace fulbito
