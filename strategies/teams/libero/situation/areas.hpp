// Private header of strategies: not installed.
#pragma once

#include "strategies/teams/libero/situation/pitch.hpp"

namespace fulbito::libero {

/// Whether `p` lies in our goal area, widened by `margin` [m]; the arc counts as a box.
bool inOwnArea(const Pitch& pitch, Vec2 p, double margin = 0.0);
/// The same of theirs.
bool inTheirArea(const Pitch& pitch, Vec2 p, double margin = 0.0);

/// `p` moved out of our area by the shortest way; stays where it is outside.
Vec2 outOfOwnArea(const Pitch& pitch, Vec2 p, double margin);
Vec2 outOfTheirArea(const Pitch& pitch, Vec2 p, double margin);

/// How far [m] `p` lies outside our goal area, the arc as it is; negative inside.
double outsideOwnArea(const Pitch& pitch, Vec2 p);

}  // namespace fulbito::libero
