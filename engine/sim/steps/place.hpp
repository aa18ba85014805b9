#pragma once

#include <cmath>

#include <box2d/b2_body.h>
#include <box2d/b2_math.h>

namespace fulbito {

/// Where a body is, in Box2D's units and frame.
struct Place {
  b2Vec2 middle;
  b2Vec2 ahead;  ///< unit
};

/// A body's outline: a box, or a disc, which is a point with a radius around it.
struct Outline {
  const b2Body* body;
  float half_length;
  float half_width;
  float radius;  ///< added around the box
  float reach;   ///< largest distance of the outline from the body's centre
};

inline Outline boxOf(const b2Body* body, float half_length, float half_width) {
  return {body, half_length, half_width, 0.0f,
          std::sqrt(half_length * half_length + half_width * half_width)};
}

inline Outline discOf(const b2Body* body, float radius) { return {body, 0.0f, 0.0f, radius, radius}; }

inline Place placeOf(const b2Body& body) {
  const b2Rot& turn = body.GetTransform().q;
  return {body.GetPosition(), {turn.c, turn.s}};
}

/// [rad] Largest turn for `turnedBy`. Larger ones could move a corner through another body and out again.
inline constexpr float kFarTurn = 0.25f;

/// A quarter of a turn to the left.
inline b2Vec2 across(b2Vec2 ahead) { return {-ahead.y, ahead.x}; }

/// A unit vector after a turn by up to `kFarTurn` [rad].
inline b2Vec2 turnedBy(b2Vec2 ahead, float angle) {
  const float half = angle * angle / 2.0f;
  return (1.0f - half) * ahead + angle * (1.0f - half / 3.0f) * across(ahead);
}

}  // namespace fulbito
