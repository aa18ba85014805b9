#include "engine/sim/contact_log.hpp"

#include <algorithm>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>

#include "engine/sim/contacts/meeting_face.hpp"
#include "engine/sim/units.hpp"
#include "engine/sim/walls.hpp"

namespace fulbito {
namespace {

std::size_t numberOf(b2Fixture* fixture) { return fixture->GetBody()->GetUserData().pointer; }

b2Vec2 normalToward(const b2Body& body, b2Contact& contact) {
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  return contact.GetFixtureB()->GetBody() == &body ? manifold.normal : -manifold.normal;
}

// A ball between a robot and a wall bounces between the two, ever slower, until both rest: if the ball is the
// lighter body, it returns no speed (docs/models.md). Without this case, the wall would bounce both back.
bool isPinned(b2Body& ball, b2Vec2 from_wall) {
  constexpr float kOpposed =
      -0.05f;  // cosine between the two normals; motion along a wall does not press on it
  for (b2ContactEdge* edge = ball.GetContactList(); edge != nullptr; edge = edge->next) {
    if (edge->other->GetType() != b2_dynamicBody || !edge->contact->IsTouching()) continue;
    if (b2Dot(from_wall, normalToward(ball, *edge->contact)) < kOpposed) return true;
  }
  return false;
}

bool comesBefore(BodyId a, BodyId b) { return a.kind != b.kind ? a.kind < b.kind : a.index < b.index; }

bool comesBefore(const ContactEvent& x, const ContactEvent& y) {
  return x.a == y.a ? comesBefore(x.b, y.b) : comesBefore(x.a, y.a);
}

}  // namespace

ContactLog::ContactLog(std::vector<BodyId> bodies, std::vector<Surface> surfaces, std::vector<Vec2> walls,
                       Squeeze squeeze)
    : bodies_(std::move(bodies)),
      surfaces_(std::move(surfaces)),
      walls_(std::move(walls)),
      pairs_(bodies_.size() * bodies_.size()),
      squeeze_(std::move(squeeze)) {
  // A body touches at most about six others.
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

void ContactLog::PreSolve(b2Contact* contact, const b2Manifold* before) {
  ++unsolved_;
  const bool wall_first = numberOf(contact->GetFixtureA()) == 0;
  if (!wall_first && numberOf(contact->GetFixtureB()) != 0) {
    chooseMeetingFace(*contact, *before);
    stopBouncing(*contact, *before);
    return lookAtSurface(*contact);
  }
  b2Fixture& wall = *(wall_first ? contact->GetFixtureA() : contact->GetFixtureB());
  b2Body& body = *(wall_first ? contact->GetFixtureB() : contact->GetFixtureA())->GetBody();
  const b2Vec2 normal = normalToward(body, *contact);
  const Vec2 push{static_cast<double>(normal.x), static_cast<double>(normal.y)};
  if (!pushesInward(walls_[wall.GetUserData().pointer], push)) {
    contact->SetEnabled(false);
    --unsolved_;
    return;
  }
  const Surface& surface = surfaces_[body.GetUserData().pointer];
  if (surface.kind != Surface::Kind::kBall) return;
  const double bounce = isPinned(body, normal) ? 0.0 : pairOf(surfaces_[0], surface).restitution;
  contact->SetRestitution(static_cast<float>(bounce));
}

// Robots that push on each other approach within each step, as motors and tyres act before contacts. That is
// no impact, and must not throw them apart.
void ContactLog::stopBouncing(b2Contact& contact, const b2Manifold& before) const {
  const bool ball = isBall(numberOf(contact.GetFixtureA())) || isBall(numberOf(contact.GetFixtureB()));
  if (!ball && before.pointCount > 0) contact.SetRestitution(0.0f);
}

void ContactLog::lookAtSurface(b2Contact& contact) {
  const std::size_t a = numberOf(contact.GetFixtureA()), b = numberOf(contact.GetFixtureB());
  if (!isBall(a) && !isBall(b)) return;
  b2WorldManifold manifold;
  contact.GetWorldManifold(&manifold);
  pairAt(std::min(a, b), std::max(a, b)).surface_speed = surfaceSpeed(contact, manifold.points[0]);
}

// The largest speed at the point among the bodies that touch a ball there.
float ContactLog::surfaceSpeed(b2Contact& contact, b2Vec2 point) const {
  const auto speed = [&](b2Fixture* fixture, b2Fixture* other) {
    if (!isBall(numberOf(other))) return 0.0f;
    return fixture->GetBody()->GetLinearVelocityFromWorldPoint(point).Length();
  };
  return std::max(speed(contact.GetFixtureA(), contact.GetFixtureB()),
                  speed(contact.GetFixtureB(), contact.GetFixtureA()));
}

void ContactLog::press(b2Contact& contact, b2Vec2 point, const Pair& pair) {
  // Another body may hit the one that touches the ball and speed it up within the step.
  const float speed = std::max(pair.surface_speed, surfaceSpeed(contact, point));
  const std::size_t a = numberOf(contact.GetFixtureA()), b = numberOf(contact.GetFixtureB());
  if (isBall(a)) squeeze_.press(bodies_[a].index, b, speed, contact.GetRestitution());
  if (isBall(b)) squeeze_.press(bodies_[b].index, a, speed, contact.GetRestitution());
}

void ContactLog::PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) {
  solved_ = true;
  record(*contact, *impulse);
  if (--unsolved_ == 0 && on_solved_) on_solved_();
}

void ContactLog::record(b2Contact& contact, const b2ContactImpulse& impulse) {
  const std::size_t first = numberOf(contact.GetFixtureA()), second = numberOf(contact.GetFixtureB());
  const std::size_t a = std::min(first, second), b = std::max(first, second);
  Pair& pair = pairAt(a, b);

  double sum = 0.0;
  for (int i = 0; i < impulse.count; ++i) sum += static_cast<double>(impulse.normalImpulses[i]);
  if (!(sum > 0.0)) {  // close, but without force: at most the end of an earlier contact
    if (pair.touched >= tick_ - 1) pair.touched = tick_;
    return;
  }
  const bool is_new = pair.event_tick != tick_, on_ball = isBall(a) || isBall(b);
  if (is_new || on_ball) {
    b2WorldManifold manifold;
    contact.GetWorldManifold(&manifold);
    if (on_ball) press(contact, manifold.points[0], pair);
    const double sign = first == a ? 1.0 : -1.0;
    const Vec2 normal{sign * static_cast<double>(manifold.normal.x),
                      sign * static_cast<double>(manifold.normal.y)};
    if (bodies_[a].kind == BodyKind::kWall && on_ball) wall_hits_.push_back({bodies_[b].index, normal});
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
