#include "engine/sim/approach.hpp"

#include <algorithm>
#include <cmath>

#include <box2d/b2_body.h>

namespace fulbito {
namespace {

constexpr float kFarTurn =
    0.25f;  // [rad] larger turns could move a corner through another body and out again

b2Vec2 across(b2Vec2 ahead) { return {-ahead.y, ahead.x}; }

}  // namespace

void Approach::addBox(const b2Body* body, float half_length, float half_width) {
  const float reach = std::sqrt(half_length * half_length + half_width * half_width);
  movers_.push_back({body, half_length, half_width, 0.0f, reach});
  ++boxes_;
}

void Approach::addDisc(const b2Body* body, float radius) {
  movers_.push_back({body, 0.0f, 0.0f, radius, radius});
}

void Approach::addWall(b2Vec2 from, b2Vec2 to) {
  b2Vec2 along = to - from;
  const float length = along.Normalize();
  faces_.push_back({0.5f * (from + to), {along.y, -along.x}, length / 2});
}

// The place after a share of the step, for turns of up to kFarTurn.
Approach::Place Approach::placeAfter(const Mover& mover, float share) {
  const float angle = share * mover.angle, half = angle * angle / 2.0f;
  const b2Vec2 ahead =
      (1.0f - half) * mover.now.ahead + angle * (1.0f - half / 3.0f) * across(mover.now.ahead);
  return {mover.now.middle + share * mover.change, ahead};
}

bool Approach::inReach(const Mover& a, const Mover& b) {
  const float reach = a.reach + b.reach + a.travel + b.travel;
  return (b.now.middle - a.now.middle).LengthSquared() <= reach * reach;
}

// The gap along separating axes; negative if they overlap. Near a corner it is less than the distance.
float Approach::gap(const Mover& box, const Place& at_box, const Mover& other, const Place& at_other) {
  const b2Vec2 apart = at_other.middle - at_box.middle;
  const float along = std::abs(b2Dot(at_box.ahead, apart)), beside = std::abs(b2Cross(at_box.ahead, apart));
  if (other.radius > 0.0f) {  // a disc has no axes of its own
    return std::max(along - box.half_length, beside - box.half_width) - other.radius;
  }
  const float same = std::abs(b2Dot(at_box.ahead, at_other.ahead));
  const float turned = std::abs(b2Cross(at_box.ahead, at_other.ahead));
  const auto extent = [&](float half, const Mover& of, float first, float second) {
    return half + of.half_length * first + of.half_width * second;
  };
  const float by_box = std::max(along - extent(box.half_length, other, same, turned),
                                beside - extent(box.half_width, other, turned, same));
  const float by_other =
      std::max(std::abs(b2Dot(at_other.ahead, apart)) - extent(other.half_length, box, same, turned),
               std::abs(b2Cross(at_other.ahead, apart)) - extent(other.half_width, box, turned, same));
  return std::max(by_box, by_other);
}

// Updates place and motion of all bodies.
void Approach::look(float dt) {
  for (Mover& mover : movers_) {
    const b2Rot& turn = mover.body->GetTransform().q;
    mover.now = {mover.body->GetPosition(), {turn.c, turn.s}};
    mover.change = dt * mover.body->GetLinearVelocity();
    mover.angle = dt * mover.body->GetAngularVelocity();
    mover.travel = mover.change.Length();
    mover.turn = std::abs(mover.angle) * mover.reach;
    mover.crowded = false;
  }
}

// Whether they can meet in the step even if another body stops one of them on the way.
bool Approach::meet(const Mover& box, const Mover& other, Meeting& meeting) const {
  if (!inReach(box, other)) return false;
  meeting.before = gap(box, box.now, other, other.now);
  const float turns = box.turn + other.turn;
  if (meeting.before > box.travel + other.travel + turns + 2.0f * depth_) return false;
  meeting.moved = (other.change - box.change).Length() + turns;
  return true;
}

// How much deeper two bodies may overlap. The engine already stops touching bodies, so their steps are split
// only if they still move fast, and sooner if the engine has let them overlap before.
float Approach::allowed(float before) const {
  if (before > 0.0f) return depth_;
  return before > -depth_ ? 2.0f * depth_ : depth_ / 2.0f;
}

// The share of the step after which two bodies, `before` apart now and `after` apart later, reach the limit.
float Approach::shareOf(float before, float after) const {
  const float gap = std::max(before, 0.0f), deeper = std::min(before, 0.0f) - after;
  const float most = allowed(before);
  return deeper <= most ? 1.0f : (gap + most) / (gap + deeper);
}

float Approach::shareOfPair(const Mover& box, const Mover& other, const Meeting& meeting) const {
  if (meeting.moved <= std::max(meeting.before, 0.0f) + allowed(meeting.before)) return 1.0f;
  const float turn = std::max(std::abs(box.angle), std::abs(other.angle));
  const float part = turn > kFarTurn ? kFarTurn / turn : 1.0f;
  return part * shareOf(meeting.before, gap(box, placeAfter(box, part), other, placeAfter(other, part)));
}

bool Approach::isByWall(const Mover& mover) const {
  const b2Vec2 now = b2Abs(mover.now.middle);
  const float near = mover.reach + mover.travel + 2.0f * depth_;
  return now.x + near > open_.x || now.y + near > open_.y;
}

float Approach::shareAtWalls(const Mover& mover) const {
  float least = 1.0f;
  for (const Face& face : faces_) {
    const float toward = b2Dot(face.out, mover.change);
    if (toward <= depth_) continue;
    const b2Vec2 from = mover.now.middle - face.middle;
    if (std::abs(b2Cross(face.out, from)) > face.half + mover.reach + mover.travel) continue;
    const float extent = mover.half_length * std::abs(b2Dot(face.out, mover.now.ahead)) +
                         mover.half_width * std::abs(b2Cross(face.out, mover.now.ahead)) + mover.radius;
    const float before = -b2Dot(face.out, from) - extent;
    if (before > -mover.reach) least = std::min(least, shareOf(before, before - toward));
  }
  return least;
}

void Approach::planBoxes(Plan& plan) {
  Meeting meeting;
  for (std::size_t i = 0; i < boxes_; ++i) {
    for (std::size_t k = i + 1; k < boxes_; ++k) {
      Mover &a = movers_[i], &b = movers_[k];
      if (!meet(a, b, meeting)) continue;
      a.crowded = b.crowded = true;
      plan.share = std::min(plan.share, shareOfPair(a, b, meeting));
    }
  }
}

// The engine solves a disc correctly in a whole step if it rolls slowly or one body pushes it, but not if it
// is fast or between two bodies.
void Approach::planDisc(Mover& disc, Plan& plan) {
  int near = isByWall(disc) ? 1 : 0;
  Meeting meeting;
  for (std::size_t i = 0; i < boxes_; ++i) {
    const Mover& box = movers_[i];
    if (!meet(box, disc, meeting)) continue;
    if (meeting.before <= meeting.moved + 2.0f * depth_) ++near, disc.crowded = true;
    plan.continuous |= near > 1 || meeting.moved > depth_;
    if (bullets_ && !box.crowded) continue;
    disc.crowded = true;
    plan.share = std::min(plan.share, shareOfPair(box, disc, meeting));
  }
}

void Approach::planDiscs(Plan& plan) {
  for (std::size_t k = boxes_; k < movers_.size(); ++k) {
    planDisc(movers_[k], plan);
    for (std::size_t i = boxes_; i < k; ++i) plan.continuous |= inReach(movers_[i], movers_[k]);
  }
}

void Approach::planWalls(Plan& plan) const {
  for (const Mover& mover : movers_) {
    if (mover.travel <= depth_ || !isByWall(mover)) continue;
    const float share = shareAtWalls(mover);
    if (share < 1.0f) plan.continuous = true;
    if (mover.crowded) plan.share = std::min(plan.share, share);
  }
}

Approach::Plan Approach::plan(float dt) {
  Plan plan;
  if (!(depth_ > 0.0f)) return plan;
  plan.continuous = always_continuous_;
  look(dt);
  planBoxes(plan);
  planDiscs(plan);
  planWalls(plan);
  return plan;
}

}  // namespace fulbito
