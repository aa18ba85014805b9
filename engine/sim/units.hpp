#pragma once

#include <box2d/b2_math.h>

#include "fulbito/detail/vec2.hpp"

/// Conversion between SI units and Box2D's units, only here. Box2D's tolerances are absolute and meant for
/// bodies of 0.1 ... 10 units, so the world is scaled up: at 10 units per metre, its slop is 0.5 mm. Masses
/// stay in kg, times in s and angles in rad. Lengths, speeds and linear impulses scale by 10, angular
/// impulses by 100.
namespace fulbito::units {

inline constexpr double kPerMetre = 10.0;
inline constexpr double kMetres = 0.1;  // [m] length of a unit; multiplying is cheaper than dividing

/// Box2D gives polygons a skin of 1 mm each, minus 0.5 mm of allowed overlap, and lets two circles overlap by
/// 0.5 mm. To make the intended outlines touch, the inset is subtracted from half sizes (walls move out by
/// the same amount) and the outset is added to radii.
inline constexpr double kPolygonInset = 0.00075;  // [m]
inline constexpr double kCircleOutset = 0.00025;  // [m]

inline float length(double metres) { return static_cast<float>(metres * kPerMetre); }
inline double metres(float length) { return static_cast<double>(length) * kMetres; }
inline b2Vec2 vector(Vec2 v) { return {length(v.x), length(v.y)}; }
inline Vec2 metres(const b2Vec2& v) { return {metres(v.x), metres(v.y)}; }

}  // namespace fulbito::units
