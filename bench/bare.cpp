#include "bench/bare.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_world.h>

#include "engine/sim/walls.hpp"

namespace fulbito {
namespace {

constexpr float kScale = 10.0f;  // Box2D units per metre

struct BareRobot {
  b2Body* body;
  float wheel_radius;
  float half_track;
  float gain;     // largest change of a rim's speed by the motor in one step
  float loss;     // largest change of a rim's speed in one step while braking
  float grip;     // largest change of speed that the floor transmits in one step
  float lateral;  // the same limit sideways
  float share;    // ratio of the motors' effect on rotation to that on translation
  float left = 0.0f;
  float right = 0.0f;
};

float pull(const BareRobot& robot, float target, float ground) {
  const bool slows = target * ground < 0.0f || std::abs(target) < std::abs(ground);
  const float limit = slows ? robot.loss : robot.gain;
  return std::clamp(std::clamp(target - ground, -limit, limit), -robot.grip, robot.grip);
}

void drive(BareRobot& robot) {
  const b2Rot q = robot.body->GetTransform().q;
  const b2Vec2 velocity = robot.body->GetLinearVelocity(), ahead(q.c, q.s), side(-q.s, q.c);
  const float forward = b2Dot(velocity, ahead), turn = robot.body->GetAngularVelocity() * robot.half_track;
  const float left = pull(robot, robot.left, forward - turn),
              right = pull(robot, robot.right, forward + turn);
  const float sideways = std::clamp(b2Dot(velocity, side), -robot.lateral, robot.lateral);
  robot.body->ApplyLinearImpulseToCenter(
      robot.body->GetMass() * (0.5f * (left + right) * ahead - sideways * side), true);
  const float yaw = robot.share * (right - left) / (2.0f * robot.half_track);
  robot.body->ApplyAngularImpulse(robot.body->GetInertia() * yaw, true);
}

void addFixture(b2Body& body, const b2Shape& shape, float friction, float restitution, float threshold) {
  b2FixtureDef def;
  def.shape = &shape;
  def.friction = friction;
  def.restitution = restitution;
  def.restitutionThreshold = threshold;
  body.CreateFixture(&def);
}

void setMass(b2Body& body, double mass, double inertia) {
  b2MassData data;
  data.mass = static_cast<float>(mass);
  data.center.SetZero();
  data.I = static_cast<float>(inertia * 100.0);
  body.SetMassData(&data);
}

// Gives the ball its own restitution and spin loss at walls, which Box2D's mixing of coefficients cannot
// express.
struct BallAtWall : b2ContactListener {
  const b2Body* ball = nullptr;
  const b2Body* walls = nullptr;
  float restitution = 0.0f;
  float spin_keep = 0.0f;
  b2Vec2 spin{0.0f, 0.0f};

  bool concerns(b2Contact* contact) const {
    const b2Body *a = contact->GetFixtureA()->GetBody(), *b = contact->GetFixtureB()->GetBody();
    return (a == ball && b == walls) || (a == walls && b == ball);
  }
  void BeginContact(b2Contact* contact) override {
    if (concerns(contact)) contact->SetRestitution(restitution);
  }
  void PostSolve(b2Contact* contact, const b2ContactImpulse* impulse) override {
    if (!concerns(contact) || impulse->normalImpulses[0] <= 0.0f) return;
    b2WorldManifold manifold;
    contact->GetWorldManifold(&manifold);
    spin -= (1.0f - spin_keep) * b2Dot(spin, manifold.normal) * manifold.normal;
  }
};

float scaled(double metres) { return static_cast<float>(metres) * kScale; }

}  // namespace

struct BareLoop::Impl {
  BallAtWall listener;
  b2World world{b2Vec2{0.0f, 0.0f}};
  std::vector<BareRobot> robots;
  std::vector<Pose2> poses;
  b2Body* ball = nullptr;
  float keep = 0.0f;
  float slide = 0.0f;
  float roll = 0.0f;
  float rest = 0.0f;
  float dt = 0.0f;
  int substeps = 1;
  int velocity_iterations = 8;
  int position_iterations = 3;

  void addWalls(const WorldConfig& config);
  void addRobot(const WorldConfig& config, const RobotPlacement& placement);
  void addBall(const WorldConfig& config, const BallPlacement& placement);
  void rollBall();
  void readPoses();
};

void BareLoop::Impl::addWalls(const WorldConfig& config) {
  const b2BodyDef def;
  b2Body* body = world.CreateBody(&def);
  listener.walls = body;
  for (const WallOutline& outline : wallOutlines(config.field, 0.00075)) {
    b2Vec2 points[4];
    for (int i = 0; i < 4; ++i) {
      const Vec2 p = outline[static_cast<std::size_t>(i)];
      points[i] = {scaled(p.x), scaled(p.y)};
    }
    b2PolygonShape shape;
    shape.Set(points, 4);
    addFixture(*body, shape, 0.2f, 0.0f, scaled(config.physics.restitution_threshold));
  }
}

void BareLoop::Impl::addRobot(const WorldConfig& config, const RobotPlacement& placement) {
  const RobotModel& m = placement.model;
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = {scaled(placement.pose.position.x), scaled(placement.pose.position.y)};
  def.angle = static_cast<float>(placement.pose.heading);
  def.allowSleep = false;
  b2Body* body = world.CreateBody(&def);
  b2PolygonShape shape;
  shape.SetAsBox(scaled(m.length / 2 - 0.00075), scaled(m.width / 2 - 0.00075));
  addFixture(*body, shape, static_cast<float>(m.friction), static_cast<float>(m.restitution),
             scaled(config.physics.restitution_threshold));
  setMass(*body, m.mass, m.mass * (m.length * m.length + m.width * m.width) / 12);
  robots.push_back({body, scaled(m.wheel_radius), scaled(m.axle_track / 2), scaled(m.wheel_acceleration) * dt,
                    scaled(m.wheel_braking) * dt, scaled(m.longitudinal_grip) * dt,
                    scaled(m.lateral_grip) * dt, static_cast<float>(m.turnShare())});
}

void BareLoop::Impl::addBall(const WorldConfig& config, const BallPlacement& placement) {
  const BallModel& m = placement.model;
  b2BodyDef def;
  def.type = b2_dynamicBody;
  def.position = {scaled(placement.position.x), scaled(placement.position.y)};
  def.allowSleep = false;
  def.fixedRotation = true;
  def.bullet = config.physics.bullet_ball;
  ball = world.CreateBody(&def);
  listener.ball = ball;
  listener.restitution = static_cast<float>(m.wall_restitution);
  listener.spin_keep = static_cast<float>(m.wall_spin_keep);
  b2CircleShape shape;
  shape.m_radius = scaled(m.radius + 0.00025);
  // Box2D mixes friction by the square root of the product, and restitution by the maximum. With 0.2 for
  // robots and walls and 0.05 for the ball, the friction is 0.1 as in the engine.
  addFixture(*ball, shape, 0.05f, static_cast<float>(m.robot_restitution),
             scaled(config.physics.restitution_threshold));
  setMass(*ball, m.mass, 0.0);
  keep = static_cast<float>(m.roll_keep);
  slide = scaled(m.slide_deceleration) * dt;
  roll = scaled(m.roll_deceleration) * dt;
  rest = scaled(m.stop_speed);
}

void BareLoop::Impl::rollBall() {
  b2Vec2& spin = listener.spin;
  const b2Vec2 velocity = ball->GetLinearVelocity(), slip = velocity - spin;
  const float slip_speed = slip.Length();
  b2Vec2 after;
  if (slip_speed * (1.0f - keep) <= slide) {
    after = keep * velocity + (1.0f - keep) * spin;
    const float speed = after.Length();
    after = speed - roll > rest ? (1.0f - roll / speed) * after : b2Vec2(0.0f, 0.0f);
    spin = after;
  } else {
    const b2Vec2 lost = (slide / slip_speed) * slip;
    after = velocity - lost;
    spin += (keep / (1.0f - keep)) * lost;
  }
  ball->ApplyLinearImpulseToCenter(ball->GetMass() * (after - velocity), true);
}

void BareLoop::Impl::readPoses() {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const b2Vec2 p = robots[i].body->GetPosition();
    poses[i] = {{static_cast<double>(p.x / kScale), static_cast<double>(p.y / kScale)},
                static_cast<double>(robots[i].body->GetAngle())};
  }
}

BareLoop::BareLoop(const WorldConfig& config) : impl_(std::make_unique<Impl>()) {
  impl_->dt = static_cast<float>(config.physics.stepPeriod());
  impl_->substeps = config.physics.substeps;
  impl_->velocity_iterations = config.physics.velocity_iterations;
  impl_->position_iterations = config.physics.position_iterations;
  impl_->world.SetAllowSleeping(false);
  impl_->world.SetContactListener(&impl_->listener);
  impl_->addWalls(config);
  for (const RobotPlacement& robot : config.robots) impl_->addRobot(config, robot);
  impl_->addBall(config, config.balls.front());
  impl_->poses.resize(config.robots.size());
  impl_->readPoses();
}
BareLoop::BareLoop(BareLoop&&) noexcept = default;
BareLoop::~BareLoop() = default;

void BareLoop::step(std::span<const WheelSpeeds> commands) {
  Impl& loop = *impl_;
  for (std::size_t i = 0; i < loop.robots.size(); ++i) {
    BareRobot& robot = loop.robots[i];
    robot.left = static_cast<float>(commands[i].left) * robot.wheel_radius;
    robot.right = static_cast<float>(commands[i].right) * robot.wheel_radius;
  }
  for (int i = 0; i < loop.substeps; ++i) {
    for (BareRobot& robot : loop.robots) drive(robot);
    loop.rollBall();
    loop.world.Step(loop.dt, loop.velocity_iterations, loop.position_iterations);
  }
  loop.readPoses();
}

std::span<const Pose2> BareLoop::robots() const { return impl_->poses; }

Vec2 BareLoop::ball() const {
  const b2Vec2 p = impl_->ball->GetPosition();
  return {static_cast<double>(p.x / kScale), static_cast<double>(p.y / kScale)};
}

int BareLoop::touchingPairs() const {
  int count = 0;
  for (const b2Contact* c = impl_->world.GetContactList(); c != nullptr; c = c->GetNext())
    count += c->IsTouching() ? 1 : 0;
  return count;
}

}  // namespace fulbito
