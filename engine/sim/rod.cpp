#include "engine/sim/rod.hpp"

#include <box2d/b2_body.h>
#include <box2d/b2_revolute_joint.h>
#include <box2d/b2_world.h>

#include "engine/sim/units.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

b2Body* addBody(b2World& world, const RodPlacement& rod, const b2Body& first, const b2Body& second) {
  const Vec2 a = units::metres(first.GetPosition()), b = units::metres(second.GetPosition());
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = units::vector((a + b) / 2);
  def.angle = static_cast<float>(math::angleOf(b - a));
  def.linearVelocity = 0.5f * (first.GetLinearVelocity() + second.GetLinearVelocity());
  def.allowSleep = false;
  b2Body* body = world.CreateBody(&def);
  b2MassData data;
  data.mass = static_cast<float>(rod.mass);
  data.center.SetZero();
  data.I = static_cast<float>(rod.mass * rod.length * rod.length / 12 * units::kPerMetre * units::kPerMetre);
  body->SetMassData(&data);
  return body;
}

b2RevoluteJoint* addJoint(b2World& world, b2Body& robot, b2Body& rod, double along) {
  b2RevoluteJointDef def;
  def.bodyA = &robot;
  def.bodyB = &rod;
  def.localAnchorA.SetZero();
  def.localAnchorB = {units::length(along), 0.0f};
  def.collideConnected = true;
  return static_cast<b2RevoluteJoint*>(world.CreateJoint(&def));
}

}  // namespace

CarriedRod::CarriedRod(b2World& world, const RodPlacement& rod, b2Body& first, b2Body& second)
    : body_(addBody(world, rod, first, second)),
      joints_{addJoint(world, first, *body_, -rod.length / 2),
              addJoint(world, second, *body_, rod.length / 2)} {}

void CarriedRod::addImpulses() {
  // At 1 Hz a force is an impulse; the engine gives the one on the joint's second body.
  for (std::size_t i = 0; i < joints_.size(); ++i)
    impulses_[i] += units::metres(joints_[i]->GetReactionForce(1.0f));
}

RodState CarriedRod::state(double period) const {
  RodState state;
  state.pose = {units::metres(body_->GetPosition()), math::wrapAngle(static_cast<double>(body_->GetAngle()))};
  state.velocity = units::metres(body_->GetLinearVelocity());
  state.angular_velocity = static_cast<double>(body_->GetAngularVelocity());
  for (std::size_t i = 0; i < impulses_.size(); ++i) state.forces[i] = impulses_[i] / period;
  return state;
}

}  // namespace fulbito
