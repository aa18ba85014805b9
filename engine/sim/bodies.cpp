#include "engine/sim/bodies.hpp"

#include <array>

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "engine/sim/obstacle_motion.hpp"
#include "engine/sim/units.hpp"
#include "engine/sim/walls.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

b2BodyDef definition(b2BodyType type, const Pose2& pose, std::size_t number) {
  b2BodyDef def;
  def.type = type;
  def.position = units::vector(pose.position);
  def.angle = static_cast<float>(math::wrapAngle(pose.heading));
  def.allowSleep = false;
  def.userData.pointer = number;
  return def;
}

// Friction and restitution depend on the pair: ContactLog sets them at contact.
void addShape(b2Body& body, const b2Shape& shape, const WorldConfig& config, std::size_t part = 0) {
  b2FixtureDef def;
  def.userData.pointer = part;
  def.shape = &shape;
  def.restitutionThreshold = units::length(config.physics.restitution_threshold);
  body.CreateFixture(&def);
}

void addBox(b2Body& body, double length, double width, const WorldConfig& config) {
  b2PolygonShape box;
  box.SetAsBox(units::length(length / 2 - units::kPolygonInset),
               units::length(width / 2 - units::kPolygonInset));
  addShape(body, box, config);
}

void addDisc(b2Body& body, double radius, const WorldConfig& config) {
  b2CircleShape disc;
  disc.m_radius = units::length(radius + units::kCircleOutset);
  addShape(body, disc, config);
}

void setMass(b2Body& body, double mass, double inertia) {
  b2MassData data;
  data.mass = static_cast<float>(mass);
  data.center.SetZero();
  data.I = static_cast<float>(inertia * units::kPerMetre * units::kPerMetre);
  body.SetMassData(&data);
}

b2BodyType typeOf(ObstacleMotion motion) {
  if (motion == ObstacleMotion::kFixed) return b2_staticBody;
  return motion == ObstacleMotion::kPath ? b2_kinematicBody : b2_dynamicBody;
}

}  // namespace

b2Body* addWalls(b2World& world, const WorldConfig& config, std::size_t number) {
  const b2BodyDef def = definition(b2_staticBody, {}, number);
  b2Body* body = world.CreateBody(&def);
  std::size_t part = 0;
  for (const WallOutline& outline : wallOutlines(config.field, units::kPolygonInset)) {
    std::array<b2Vec2, 4> points;
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = units::vector(outline[i]);
    b2PolygonShape wall;
    wall.Set(points.data(), static_cast<int32>(points.size()));
    addShape(*body, wall, config, part++);
  }
  return body;
}

b2Body* addRobot(b2World& world, const WorldConfig& config, const RobotPlacement& robot, std::size_t number) {
  const RobotModel& model = robot.model;
  b2BodyDef def = definition(b2_dynamicBody, robot.pose, number);
  def.linearVelocity = units::vector(robot.velocity);
  def.angularVelocity = static_cast<float>(robot.angular_velocity);
  b2Body* body = world.CreateBody(&def);
  addBox(*body, model.length, model.width, config);
  setMass(*body, model.mass, model.inertia());
  return body;
}

b2Body* addBall(b2World& world, const WorldConfig& config, const BallPlacement& ball, std::size_t number) {
  b2BodyDef def = definition(b2_dynamicBody, {ball.position, 0.0}, number);
  def.linearVelocity = units::vector(ball.velocity);
  def.bullet = config.physics.bullet_ball;
  def.fixedRotation = true;  // the relevant spin is about a horizontal axis: BallState::spin
  b2Body* body = world.CreateBody(&def);
  addDisc(*body, ball.model.radius, config);
  setMass(*body, ball.model.mass, 0.0);
  return body;
}

b2Body* addObstacle(b2World& world, const WorldConfig& config, const ObstacleSpec& obstacle,
                    std::size_t number) {
  const bool moves = obstacle.motion == ObstacleMotion::kPath;
  const Pose2 pose{moves ? positionAt(obstacle, 0.0) : obstacle.pose.position, obstacle.pose.heading};
  const b2BodyDef def = definition(typeOf(obstacle.motion), pose, number);
  b2Body* body = world.CreateBody(&def);
  if (obstacle.shape == ObstacleShape::kDisc) {
    addDisc(*body, obstacle.radius, config);
  } else {
    addBox(*body, obstacle.length, obstacle.width, config);
  }
  if (obstacle.motion == ObstacleMotion::kPushable) setMass(*body, obstacle.mass, inertiaOf(obstacle));
  return body;
}

}  // namespace fulbito
