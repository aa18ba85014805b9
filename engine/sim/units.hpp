// Private header of engine/sim: not installed.
#pragma once

#include <box2d/b2_math.h>

#include "engine/core/base/vec2.hpp"

/// The only place where the project's SI units and Box2D's meet. Box2D's tolerances are absolute and meant
/// for bodies of 0.1 ... 10 units, so the world is scaled up: at 10 units a metre its slop is 0.5 mm. Masses
/// stay in kg, times in s, angles in rad; lengths, speeds and linear impulses scale by 10, angular impulses
/// by 100.
namespace fulbito::units {

inline constexpr double kPerMetre = 10.0;
inline constexpr double kMetres = 0.1;  // a unit's length; multiplying is cheaper than dividing

/// Box2D keeps polygons apart by a skin of 1 mm each, less 0.5 mm of allowed overlap, and lets circles
/// overlap by 0.5 mm in a pair. Taken off the half sizes (and the walls moved out by as much), or put on the
/// radii, these make the outlines that touch the outlines that are meant.
inline constexpr double kPolygonInset = 0.00075;  // [m]
inline constexpr double kCircleOutset = 0.00025;  // [m]

inline float length(double metres) { return static_cast<float>(metres * kPerMetre); }
inline double metres(float length) { return static_cast<double>(length) * kMetres; }
inline b2Vec2 vector(Vec2 v) { return {length(v.x), length(v.y)}; }
inline Vec2 metres(const b2Vec2& v) { return {metres(v.x), metres(v.y)}; }

}  // namespace fulbito::units
