#include "engine/sim/contacts/contact_work.hpp"

#include <box2d/b2_body.h>

namespace fulbito {

void ContactWork::remember() {
  for (Moving& m : bodies_) {
    m.velocity = m.body->GetLinearVelocity();
    m.spin = m.body->GetAngularVelocity();
  }
}

// With the impulses' share s the energy is E + s b + s^2 a: it is E again at s = -b / a.
void ContactWork::takeBack() {
  double a = 0.0, b = 0.0;
  for (const Moving& m : bodies_) {
    const double mass = static_cast<double>(m.body->GetMass()),
                 inertia = static_cast<double>(m.body->GetInertia());
    const b2Vec2 change = m.body->GetLinearVelocity() - m.velocity;
    const double turn = static_cast<double>(m.body->GetAngularVelocity() - m.spin);
    a += (mass * static_cast<double>(change.LengthSquared()) + inertia * turn * turn) / 2;
    b += mass * static_cast<double>(b2Dot(m.velocity, change)) + inertia * static_cast<double>(m.spin) * turn;
  }
  if (!(a + b > 0.0)) return;
  const float share = static_cast<float>(b < 0.0 ? -b / a : 0.0);
  for (const Moving& m : bodies_) {
    m.body->SetLinearVelocity(m.velocity + share * (m.body->GetLinearVelocity() - m.velocity));
    m.body->SetAngularVelocity(m.spin + share * (m.body->GetAngularVelocity() - m.spin));
  }
}

}  // namespace fulbito
