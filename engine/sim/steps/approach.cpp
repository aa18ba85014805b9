#include "engine/sim/steps/approach.hpp"

#include <algorithm>
#include <cmath>

namespace fulbito {
namespace {

// Share of a step: small enough that corners move nearly straight, and large enough for the precision of
// floats.
constexpr float kSoon = 0.125f;

}  // namespace

void Approach::addBox(const b2Body* body, float half_length, float half_width) {
  movers_.push_back({boxOf(body, half_length, half_width)});
  ++boxes_;
  met_.reserve(boxes_);
}

void Approach::addDisc(const b2Body* body, float radius) { movers_.push_back({discOf(body, radius)}); }

void Approach::addWall(b2Vec2 from, b2Vec2 to) {
  b2Vec2 along = to - from;
  const float length = along.Normalize();
  faces_.push_back({0.5f * (from + to), {along.y, -along.x}, length / 2});
}

// The place after a share of the step, for turns of up to kFarTurn.
Place Approach::placeAfter(const Mover& mover, float share) {
  return {mover.now.middle + share * mover.change, turnedBy(mover.now.ahead, share * mover.angle)};
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
    mover.now = placeOf(*mover.body);
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

// The share of the step after which two bodies overlap as deep as allowed; their gap is `before` now and
// `after` at the end.
float Approach::shareOf(float before, float after) const {
  const float gap = std::max(before, 0.0f), deeper = std::min(before, 0.0f) - after;
  const float most = allowed(before);
  return deeper <= most ? 1.0f : (gap + most) / (gap + deeper);
}

float Approach::gapAfter(const Mover& box, const Mover& other, float share) {
  return gap(box, placeAfter(box, share), other, placeAfter(other, share));
}

// The engine solves touching boxes by their speeds at the start of a step. It stops even corners that would
// turn out of each other's way, and boxes close behind drive on. So for touching boxes, this extrapolates the
// gap's change at the beginning of the step.
float Approach::gapAsSolved(const Mover& box, const Mover& other, float before, float share) const {
  const float after = gapAfter(box, other, share);
  if (before > depth_ || other.radius > 0.0f) return after;
  return std::min(after, before + (gapAfter(box, other, kSoon * share) - before) / kSoon);
}

float Approach::shareOfPair(const Mover& box, const Mover& other, const Meeting& meeting) const {
  if (meeting.moved <= std::max(meeting.before, 0.0f) + allowed(meeting.before)) return 1.0f;
  const float turn = std::max(std::abs(box.angle), std::abs(other.angle));
  const float part = turn > kFarTurn ? kFarTurn / turn : 1.0f;
  return part * shareOf(meeting.before, gapAsSolved(box, other, meeting.before, part));
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

bool Approach::isNear(const Meeting& meeting) const {
  return meeting.before <= meeting.moved + 2.0f * depth_;
}

// Finds the boxes that the disc can meet. If it is between boxes of which one has another box near, all of
// these are crowded: what stops one stops the others through the disc, while boxes close behind drive on.
// Returns how many boxes are near.
int Approach::meetBoxes(const Mover& disc) {
  met_.clear();
  Meeting meeting;
  int near = 0;
  bool crowded = false;
  for (std::size_t i = 0; i < boxes_; ++i) {
    if (!meet(movers_[i], disc, meeting)) continue;
    met_.push_back({&movers_[i], meeting});
    if (!isNear(meeting)) continue;
    ++near;
    crowded |= movers_[i].crowded;
  }
  if (near < 2 || !crowded) return near;
  for (const Met& met : met_) met.box->crowded |= isNear(met.meeting);
  return near;
}

// The engine solves a disc correctly in a whole step if it rolls slowly or one body pushes it, but not if it
// is fast or between two bodies.
void Approach::planDisc(Mover& disc, Plan& plan) {
  const int near = meetBoxes(disc);
  disc.crowded |= near > 0;
  plan.continuous |= near > 1 || (near > 0 && isByWall(disc));
  for (const Met& met : met_) {
    plan.continuous |= met.meeting.moved > depth_;
    if (bullets_ && !met.box->crowded) continue;
    disc.crowded = true;
    plan.share = std::min(plan.share, shareOfPair(*met.box, disc, met.meeting));
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
