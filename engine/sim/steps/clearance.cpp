#include "engine/sim/steps/clearance.hpp"

#include <algorithm>
#include <cmath>

#include <box2d/b2_contact.h>

namespace fulbito {
namespace {

// [Box2D units] The engine's search for contacts notices overlaps of at least 0.875 mm (units.hpp has the
// sizes of its shapes). The rest is a margin for rounding.
constexpr float kNoticed = 0.008f;

// [Box2D units] In the engine, a wall's other edges lie less than this outside its outline here.
constexpr float kOtherEdges = 0.02f;

constexpr float kRootHalf = 0.70710678f;

float length(b2Vec2 v) { return v.Length(); }

bool isHeld(const b2Body& body) {
  for (const b2ContactEdge* edge = body.GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->contact->IsTouching() && edge->contact->IsEnabled()) return true;
  }
  return false;
}

}  // namespace

void Clearance::addBox(const b2Body* body, float half_length, float half_width) {
  movers_.push_back({boxOf(body, half_length, half_width)});
  ++boxes_;
}

void Clearance::addDisc(const b2Body* body, float radius) { movers_.push_back({discOf(body, radius)}); }

void Clearance::setField(float half_length, float half_width, float corner) {
  field_ = {half_length, half_width};
  diagonal_ = kRootHalf * (half_length + half_width - corner);
  open_ = {half_length - corner, half_width - corner};
}

// Only the face of a wall is shifted for the engine's skin. Bodies rarely come near its other edges.
void Clearance::addWall(const std::array<b2Vec2, 4>& corners) {
  const b2Vec2 middle = 0.25f * (corners[0] + corners[1] + corners[2] + corners[3]);
  Wall wall;
  for (std::size_t i = 0; i < 4; ++i) {
    const b2Vec2 from = corners[i], along = corners[(i + 1) % 4] - from;
    b2Vec2 out = across(along);
    if (b2Dot(out, from - middle) < 0.0f) out = -out;
    out.Normalize();
    wall[i] = {from, out, i == 3 ? kNoticed : -kOtherEdges};
  }
  std::swap(wall[0], wall[3]);  // the face first: it decides most often
  walls_.push_back(wall);
}

void Clearance::remember(float dt) {
  for (Mover& mover : movers_) {
    mover.from = placeOf(*mover.body);
    mover.angle = mover.body->GetAngle();
    mover.drift = dt * mover.body->GetLinearVelocity();
    mover.spin = dt * mover.body->GetAngularVelocity();
  }
}

void Clearance::goFreely(Mover& mover) {
  mover.to = {mover.from.middle + mover.drift, turnedBy(mover.from.ahead, mover.spin)};
  mover.turn = std::abs(mover.spin);
}

// A body without motion is either held by its contacts or, if it has none, has yet to move.
void Clearance::follow(Mover& mover) {
  const float turn = mover.body->GetAngle() - mover.angle;
  if (mover.body->GetPosition() == mover.from.middle && turn == 0.0f && !isHeld(*mover.body)) {
    goFreely(mover);
  } else {
    mover.to = placeOf(*mover.body);
    mover.turn = std::abs(turn);
  }
}

float Clearance::extent(const Mover& mover, const Place& at, b2Vec2 axis) {
  return mover.half_length * std::abs(b2Dot(axis, at.ahead)) +
         mover.half_width * std::abs(b2Cross(axis, at.ahead)) + mover.radius;
}

// Upper bound of a turning corner's distance from the straight line between the two ends of its path.
float Clearance::bulge(const Mover& mover) { return mover.reach * mover.turn * mover.turn / 8.0f; }

// Upper bound of the path's length, without a square root.
float Clearance::mostWay(const Mover& mover) {
  const b2Vec2 way = b2Abs(mover.to.middle - mover.from.middle);
  return way.x + way.y;
}

// Whether one edge of the wall separates the body from it at both ends of the path by more than the bulge.
// Then it separates them all along.
bool Clearance::keepsOff(const Mover& mover, const Wall& wall) {
  return std::any_of(wall.begin(), wall.end(), [&](const Edge& edge) {
    const float least = bulge(mover) - edge.allowed;
    return b2Dot(edge.out, mover.from.middle - edge.point) - extent(mover, mover.from, edge.out) > least &&
           b2Dot(edge.out, mover.to.middle - edge.point) - extent(mover, mover.to, edge.out) > least;
  });
}

// Whether the body is inside the field without its goals, which is convex, or at most `slack` beyond its
// walls.
bool Clearance::isInside(const Mover& mover, const Place& at, float slack) const {
  const b2Vec2 middle = b2Abs(at.middle), ahead = b2Abs(at.ahead);
  const float x = middle.x + mover.half_length * ahead.x + mover.half_width * ahead.y + mover.radius;
  const float y = middle.y + mover.half_length * ahead.y + mover.half_width * ahead.x + mover.radius;
  if (x >= field_.x + slack || y >= field_.y + slack) return false;
  const float out = kRootHalf * (middle.x + middle.y);
  if (out + mover.reach < diagonal_ + slack) return true;
  // A box has two extents along the diagonals, and the larger one is safe for all.
  const float sum = kRootHalf * (ahead.x + ahead.y), difference = kRootHalf * std::abs(ahead.x - ahead.y);
  const float extent = std::max(mover.half_length * sum + mover.half_width * difference,
                                mover.half_length * difference + mover.half_width * sum);
  return out + extent + mover.radius < diagonal_ + slack;
}

bool Clearance::keepsOffWalls(const Mover& mover) const {
  const b2Vec2 farthest = b2Max(b2Abs(mover.from.middle), b2Abs(mover.to.middle));
  if (farthest.x + mover.reach < open_.x && farthest.y + mover.reach < open_.y) return true;
  const float slack = kNoticed - bulge(mover);
  if (isInside(mover, mover.from, slack) && isInside(mover, mover.to, slack)) return true;
  return std::all_of(walls_.begin(), walls_.end(), [&](const Wall& wall) { return keepsOff(mover, wall); });
}

// The box turns, so in its frame the disc's path bends. It leaves its chord by at most an eighth of its
// second derivative: the square of the turn times the distance, plus twice the turn times the path's length.
bool Clearance::keepApart(const Mover& box, const Mover& disc) {
  const b2Vec2 before = disc.from.middle - box.from.middle, after = disc.to.middle - box.to.middle;
  const float way = length(after - before), apart = length(before);
  const float bend = box.turn * (box.turn * (apart + way) + 2.0f * way) / 8.0f;
  // Least distance of the disc's centre from an axis if it is on one side of it at both ends, else <= 0.
  const auto off = [](float first, float second) {
    return std::max(std::min(first, second), -std::max(first, second));
  };
  const float along = off(b2Dot(box.from.ahead, before), b2Dot(box.to.ahead, after)) - box.half_length;
  const float beside = off(b2Cross(box.from.ahead, before), b2Cross(box.to.ahead, after)) - box.half_width;
  return std::max(along, beside) - disc.radius - bend > -kNoticed;
}

bool Clearance::keepsOffOthers(std::size_t disc) const {
  const Mover& mover = movers_[disc];
  const float own = mover.reach + mostWay(mover);
  for (std::size_t i = 0; i < disc; ++i) {
    const Mover& other = movers_[i];
    const float far = own + other.reach + mostWay(other);
    if ((mover.from.middle - other.from.middle).LengthSquared() > far * far) continue;
    if (i >= boxes_ || !keepApart(other, mover)) return false;
  }
  return true;
}

bool Clearance::isKept() const {
  for (const Mover& mover : movers_) {
    if (mover.turn > kFarTurn || !keepsOffWalls(mover)) return false;
  }
  if (!bullets_) return true;
  for (std::size_t i = boxes_; i < movers_.size(); ++i) {
    if (!keepsOffOthers(i)) return false;
  }
  return true;
}

bool Clearance::isKeptFreely() {
  for (Mover& mover : movers_) goFreely(mover);
  return isKept();
}

bool Clearance::isKeptSolved() {
  for (Mover& mover : movers_) follow(mover);
  return isKept();
}

}  // namespace fulbito
