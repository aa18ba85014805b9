#include "engine/sim/obstacle_motion.hpp"

#include <algorithm>
#include <cmath>

#include <box2d/b2_body.h>

#include "engine/sim/units.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {

double inertiaOf(const ObstacleSpec& o) {
  if (o.shape == ObstacleShape::kDisc) return o.mass * o.radius * o.radius / 2;
  return o.mass * (o.length * o.length + o.width * o.width) / 12;
}

double yawDeceleration(const ObstacleSpec& o) {
  const double radius =
      o.shape == ObstacleShape::kDisc ? o.radius : std::sqrt(o.length * o.width / math::kPi);
  return o.mass * o.floor_friction * (2.0 / 3.0) * radius / inertiaOf(o);
}

void applyFloorFriction(const ObstacleSpec& o, b2Body& body, double dt) {
  const Vec2 velocity = units::metres(body.GetLinearVelocity());
  const double speed = norm(velocity);
  if (speed > 0.0) {
    const Vec2 loss = velocity * (std::min(speed, o.floor_friction * dt) / speed);
    body.ApplyLinearImpulseToCenter(-body.GetMass() * units::vector(loss), true);
  }
  const double yaw = static_cast<double>(body.GetAngularVelocity());
  const double limit = yawDeceleration(o) * dt;
  const double yaw_loss = std::clamp(yaw, -limit, limit);
  body.ApplyAngularImpulse(-body.GetInertia() * static_cast<float>(yaw_loss), true);
}

void followPath(const ObstacleSpec& o, b2Body& body, double time, double dt) {
  const Vec2 velocity = (positionAt(o, time) - units::metres(body.GetPosition())) / dt;
  body.SetLinearVelocity(units::vector(velocity));
}

}  // namespace fulbito
