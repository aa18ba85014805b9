#include "engine/sim/contacts/squeeze.hpp"

#include <algorithm>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>

namespace fulbito {
namespace {

bool holds(const b2ContactEdge& edge) {
  return edge.other->GetType() == b2_dynamicBody && edge.contact->IsTouching();
}

}  // namespace

void Squeeze::startStep() {
  for (Ball& ball : balls_) ball = {.body = ball.body, .before = ball.body->GetLinearVelocity()};
}

void Squeeze::press(std::size_t ball, std::size_t other, float surface_speed, float restitution) {
  Ball& pressed = balls_[ball];
  if (pressed.first == kNone) pressed.first = other;
  pressed.several = pressed.several || pressed.first != other;
  pressed.surface_speed = std::max(pressed.surface_speed, surface_speed);
  pressed.restitution = std::max(pressed.restitution, restitution);
}

// A surface at speed s turns a ball's speed v into at most v + (1 + e) s.
bool Squeeze::limit() {
  bool limited = false;
  for (const Ball& ball : balls_) {
    if (!ball.several) continue;
    const float gain = (1.0f + ball.restitution) * ball.surface_speed;
    const float most = std::max(ball.before.Length() + 2.0f * gain, slow_);
    if (!(ball.body->GetLinearVelocity().LengthSquared() > most * most)) continue;
    slowTo(*ball.body, most);
    limited = true;
  }
  return limited;
}

void Squeeze::slowTo(b2Body& ball, float speed) {
  const b2Vec2 velocity = ball.GetLinearVelocity();
  const b2Vec2 given = (1.0f - speed / velocity.Length()) * velocity;
  ball.SetLinearVelocity(velocity - given);
  float holders = 0.0f;
  for (b2ContactEdge* edge = ball.GetContactList(); edge != nullptr; edge = edge->next)
    if (holds(*edge)) holders += 1.0f;
  for (b2ContactEdge* edge = ball.GetContactList(); edge != nullptr; edge = edge->next) {
    if (!holds(*edge)) continue;
    b2WorldManifold manifold;
    edge->contact->GetWorldManifold(&manifold);
    edge->other->ApplyLinearImpulse((ball.GetMass() / holders) * given, manifold.points[0], true);
  }
}

}  // namespace fulbito
