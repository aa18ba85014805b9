#include "engine/sim/contact_log.hpp"

#include <algorithm>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>

#include "engine/sim/units.hpp"

namespace fulbito {
namespace {

std::size_t numberOf(b2Fixture* fixture) { return fixture->GetBody()->GetUserData().pointer; }

bool comesBefore(BodyId a, BodyId b) { return a.kind != b.kind ? a.kind < b.kind : a.index < b.index; }

bool comesBefore(const ContactEvent& x, const ContactEvent& y) {
  return x.a == y.a ? comesBefore(x.b, y.b) : comesBefore(x.a, y.a);
}

}  // namespace

ContactLog::ContactLog(std::vector<BodyId> bodies, std::vector<Surface> surfaces)
    : bodies_(std::move(bodies)), surfaces_(std::move(surfaces)), pairs_(bodies_.size() * bodies_.size()) {
  // A body in the plane touches about six others.
  events_.reserve(8 * bodies_.size());
  wall_hits_.reserve(4 * bodies_.size());
}

void ContactLog::startTick(Tick tick) {
  tick_ = tick;
  events_.clear();
}

void ContactLog::finishTick() {
  std::sort(events_.begin(), events_.end(),
            [](const ContactEvent& x, const ContactEvent& y) { return comesBefore(x, y); });
}

void ContactLog::BeginContact(b2Contact* contact) {
  const PairSurface pair =
      pairOf(surfaces_[numberOf(contact->GetFixtureA())], surfaces_[numberOf(contact->GetFixtureB())]);
  contact->SetFriction(static_cast<float>(pair.friction));
  contact->SetRestitution(static_cast<float>(pair.restitution));
}

void ContactLog::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) {
  const std::size_t first = numberOf(contact->GetFixtureA()), second = numberOf(contact->GetFixtureB());
  const std::size_t a = std::min(first, second), b = std::max(first, second);
  Pair& pair = pairs_[a * bodies_.size() + b];

  double sum = 0.0;
  for (int i = 0; i < impulse->count; ++i) sum += static_cast<double>(impulse->normalImpulses[i]);
  if (!(sum > 0.0)) {  // near enough for the engine, but without force: at most the end of an earlier touch
    if (pair.touched >= tick_ - 1) pair.touched = tick_;
    return;
  }
  const bool wall_hit = bodies_[a].kind == BodyKind::kWall && bodies_[b].kind == BodyKind::kBall;
  const bool is_new = pair.event_tick != tick_;
  if (is_new || wall_hit) {
    b2WorldManifold manifold;
    contact->GetWorldManifold(&manifold);
    const double sign = first == a ? 1.0 : -1.0;
    const Vec2 normal{sign * static_cast<double>(manifold.normal.x),
                      sign * static_cast<double>(manifold.normal.y)};
    if (wall_hit) wall_hits_.push_back({bodies_[b].index, normal});
    if (is_new) {
      pair.event = events_.size();
      pair.event_tick = tick_;
      events_.push_back(
          {bodies_[a], bodies_[b], units::metres(manifold.points[0]), normal, 0.0, pair.touched < tick_ - 1});
    }
  }
  pair.touched = tick_;
  events_[pair.event].impulse += sum * units::kMetres;
}

}  // namespace fulbito
