#include "engine/sim/approach.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <box2d/b2_body.h>

namespace fulbito {
namespace {

b2Vec2 across(b2Vec2 ahead) { return {-ahead.y, ahead.x}; }

}  // namespace

void Approach::addBox(const b2Body* body, float half_length, float half_width) {
  const float reach = std::sqrt(half_length * half_length + half_width * half_width);
  movers_.push_back({body, half_length, half_width, 0.0f, reach, {}, {}, 0.0f, false});
  ++boxes_;
}

void Approach::addDisc(const b2Body* body, float radius) {
  movers_.push_back({body, 0.0f, 0.0f, radius, radius, {}, {}, 0.0f, false});
}

void Approach::addWall(b2Vec2 from, b2Vec2 to) {
  b2Vec2 along = to - from;
  const float length = along.Normalize();
  faces_.push_back({0.5f * (from + to), {along.y, -along.x}, length / 2});
}

// (x + y)^2 <= 2 x^2 + 2 y^2: false where they stay out of each other's reach for all of the step.
bool Approach::mayMeet(const Mover& a, const Mover& b) {
  const b2Vec2 apart = b.now.middle - a.now.middle;
  const b2Vec2 change = (b.then.middle - a.then.middle) - apart;
  const float reach = a.reach + b.reach;
  return apart.LengthSquared() <= 2.0f * (reach * reach + change.LengthSquared());
}

// How far the outline reaches from the middle along a unit axis.
float Approach::extentAlong(const Mover& mover, const Place& place, b2Vec2 axis) {
  return mover.half_length * std::abs(b2Dot(axis, place.ahead)) +
         mover.half_width * std::abs(b2Cross(axis, place.ahead)) + mover.radius;
}

// By separating axes; below 0 they overlap. Beyond a corner it is less than the distance.
float Approach::gap(const Mover& a, const Place& at_a, const Mover& b, const Place& at_b) {
  const b2Vec2 apart = at_b.middle - at_a.middle;
  const std::array<b2Vec2, 4> axes{at_a.ahead, across(at_a.ahead), at_b.ahead, across(at_b.ahead)};
  const std::size_t count = b.radius > 0.0f ? 2 : 4;  // a disc has no axes of its own
  float widest = -b2_maxFloat;
  for (std::size_t i = 0; i < count; ++i) {
    const float along = std::abs(b2Dot(axes[i], apart));
    widest = std::max(widest, along - extentAlong(a, at_a, axes[i]) - extentAlong(b, at_b, axes[i]));
  }
  return widest;
}

// For two that are `before` apart and would be `after` apart: until they are deeper by what is allowed. Those
// that press on each other slowly are left to the engine, which solves them best in whole steps.
float Approach::shareOf(float before, float after) const {
  const float gap = std::max(before, 0.0f), deeper = std::min(before, 0.0f) - after;
  const float allowed = before < -depth_ ? depth_ / 2 : depth_;
  return deeper <= allowed ? 1.0f : (gap + allowed) / (gap + deeper);
}

// They move too little for more than the allowed depth, however they lie.
bool Approach::isQuiet(const Mover& a, const Mover& b) const {
  const b2Vec2 change = (b.then.middle - b.now.middle) - (a.then.middle - a.now.middle);
  const float left = depth_ - a.turn - b.turn;
  return left > 0.0f && change.LengthSquared() < left * left;
}

float Approach::shareOfPair(const Mover& a, const Mover& b) const {
  if (isQuiet(a, b)) return 1.0f;
  return shareOf(gap(a, a.now, b, b.now), gap(a, a.then, b, b.then));
}

float Approach::shareAtWalls(const Mover& mover) const {
  const b2Vec2 far = b2Max(b2Abs(mover.now.middle), b2Abs(mover.then.middle));
  if (far.x + mover.reach < open_.x && far.y + mover.reach < open_.y) return 1.0f;
  float least = 1.0f;
  for (const Face& face : faces_) {
    const float toward = b2Dot(face.out, mover.then.middle - mover.now.middle);
    const b2Vec2 from = mover.now.middle - face.middle;
    if (toward <= depth_ || std::abs(b2Cross(face.out, from)) > face.half + mover.reach) continue;
    const float before = -b2Dot(face.out, from) - extentAlong(mover, mover.now, face.out);
    if (before > -mover.reach) least = std::min(least, shareOf(before, before - toward));
  }
  return least;
}

// Where all are and would be, and who is near whom.
void Approach::look(float dt) {
  for (Mover& mover : movers_) {
    const b2Rot& turn = mover.body->GetTransform().q;
    mover.now = {mover.body->GetPosition(), {turn.c, turn.s}};
    mover.then.middle = mover.now.middle + dt * mover.body->GetLinearVelocity();
    const float angle = dt * mover.body->GetAngularVelocity();
    mover.then.ahead = mover.now.ahead + angle * across(mover.now.ahead);
    mover.turn = std::abs(angle) * mover.reach;
    mover.crowded = false;
  }
}

float Approach::share(float dt) {
  if (!(depth_ > 0.0f)) return 1.0f;
  look(dt);
  float least = 1.0f;
  for (std::size_t i = 0; i < boxes_; ++i) {
    for (std::size_t k = i + 1; k < boxes_; ++k) {
      Mover &a = movers_[i], &b = movers_[k];
      if (!mayMeet(a, b)) continue;
      a.crowded = b.crowded = true;
      least = std::min(least, shareOfPair(a, b));
    }
  }
  for (std::size_t k = boxes_; k < movers_.size(); ++k) {
    Mover& disc = movers_[k];
    for (std::size_t i = 0; i < boxes_; ++i) {
      const Mover& box = movers_[i];
      if ((bullets_ && !box.crowded) || !mayMeet(box, disc)) continue;
      disc.crowded = true;
      least = std::min(least, shareOfPair(box, disc));
    }
  }
  for (const Mover& mover : movers_) {
    if (mover.crowded) least = std::min(least, shareAtWalls(mover));
  }
  return least;
}

}  // namespace fulbito
