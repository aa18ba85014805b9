#include "fulbito/world.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <box2d/b2_body.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_world.h>

#include "engine/core/base/float_mode.hpp"
#include "engine/sim/ball_motion.hpp"
#include "engine/sim/bodies.hpp"
#include "engine/sim/check_config.hpp"
#include "engine/sim/contact_log.hpp"
#include "engine/sim/contacts/contact_work.hpp"
#include "engine/sim/drive.hpp"
#include "engine/sim/engine_clock.hpp"
#include "engine/sim/engine_memory.hpp"
#include "engine/sim/lasting_push.hpp"
#include "engine/sim/obstacle_motion.hpp"
#include "engine/sim/reserve.hpp"
#include "engine/sim/rod.hpp"
#include "engine/sim/steps/approach.hpp"
#include "engine/sim/steps/clearance.hpp"
#include "engine/sim/units.hpp"
#include "engine/sim/walls.hpp"
#include "fulbito/detail/math.hpp"

namespace fulbito {
namespace {

constexpr int kMostParts = 64;  // largest number of parts of a physics step

Vec2 direction(const b2Body& body) {
  const b2Rot& q = body.GetTransform().q;
  return {static_cast<double>(q.c), static_cast<double>(q.s)};
}

BodyMotion inFrame(const b2Body& body, const b2Vec2& moving, float yaw) {
  const Vec2 forward = direction(body), velocity = units::metres(moving);
  return {dot(forward, velocity), cross(forward, velocity), static_cast<double>(yaw)};
}

BodyMotion motionOf(const b2Body& body) {
  return inFrame(body, body.GetLinearVelocity(), body.GetAngularVelocity());
}

Pose2 poseOf(const b2Body& body) {
  return {units::metres(body.GetPosition()), math::wrapAngle(static_cast<double>(body.GetAngle()))};
}

}  // namespace

struct World::Impl {
  struct Robot {
    b2Body* body;
    Drive drive;
    LastingPush push{};
    b2Vec2 driven{};  // [Box2D units per s] velocity after motors and tyres, before the contacts of a step
    float turned = 0.0f;  // [rad/s] yaw rate at that time
  };

  explicit Impl(const WorldConfig& from);

  void stepOnce(double time);
  void driveRobots();
  void rollBalls();
  void measurePushes();
  void moveObstacles(double time);
  void planSearch(bool search, float part);
  void decideSearch();
  void collide();
  bool isAnyPair() const;
  void unwindAngle(b2Body& body);
  void settleSpins();
  void watchMovers();
  void readState();

  WorldConfig config;
  double dt;
  b2World engine{b2Vec2{0.0f, 0.0f}};
  std::vector<Robot> robots;
  std::vector<b2Body*> balls;
  std::vector<b2Body*> obstacles;
  std::vector<CarriedRod> rods;
  ContactLog contacts;
  Approach approach;
  Clearance clearance;
  bool clearance_is_known = true;  // `clearance` has all bodies for which the engine searches
  bool searches = false;           // the engine's step may still search for contacts
  bool pairs_are_known = false;    // no body was placed since the engine looked for near ones
  ContactWork contact_work;
  bool contacts_do_no_work = true;
  float last_part = 0.0f;  // [s] length of the engine's last step
  WorldState state;

 private:
  static ContactLog makeLog(const WorldConfig& config);
};

ContactLog World::Impl::makeLog(const WorldConfig& config) {
  std::vector<BodyId> ids{{BodyKind::kWall, 0}};
  std::vector<Surface> surfaces{Surface{}};
  const auto add = [&](BodyKind kind, std::size_t index, const Surface& surface) {
    ids.push_back({kind, static_cast<std::uint16_t>(index)});
    surfaces.push_back(surface);
  };
  for (std::size_t i = 0; i < config.robots.size(); ++i)
    add(BodyKind::kRobot, i, surfaceOf(config.robots[i].model));
  for (std::size_t i = 0; i < config.balls.size(); ++i)
    add(BodyKind::kBall, i, surfaceOf(config.balls[i].model));
  Surface obstacle;
  obstacle.kind = Surface::Kind::kObstacle;
  for (std::size_t i = 0; i < config.obstacles.size(); ++i) add(BodyKind::kObstacle, i, obstacle);
  std::vector<Vec2> walls;
  for (const WallOutline& wall : wallOutlines(config.field, 0.0)) walls.push_back(inward(wall));
  return ContactLog(std::move(ids), std::move(surfaces), std::move(walls),
                    Squeeze(units::length(config.physics.restitution_threshold)));
}

World::Impl::Impl(const WorldConfig& from)
    : config(from),
      dt(from.physics.stepPeriod()),
      contacts(makeLog(from)),
      approach(units::length(from.physics.contact_depth), from.physics.bullet_ball),
      clearance(from.physics.bullet_ball) {
  useCheckedMemory();
  reserveContacts(engine, config.robots.size() + config.balls.size() + config.obstacles.size());
  engine.SetAllowSleeping(false);
  engine.SetAutoClearForces(false);  // no forces are applied, only impulses
  engine.SetContactListener(&contacts);
  contacts.onSolved([this] { decideSearch(); });
  std::size_t number = 0;
  addWalls(engine, config, number++);
  for (const RobotPlacement& robot : config.robots) {
    b2Body* body = addRobot(engine, config, robot, number++);
    robots.push_back({body, Drive(robot.model, dt, config.physics.wheel_command_step)});
  }
  for (const BallPlacement& ball : config.balls) balls.push_back(addBall(engine, config, ball, number++));
  for (const ObstacleSpec& obstacle : config.obstacles)
    obstacles.push_back(addObstacle(engine, config, obstacle, number++));
  for (const RodPlacement& rod : config.rods)
    rods.emplace_back(engine, rod, *robots[rod.first].body, *robots[rod.second].body);
  watchMovers();

  state.robots.resize(robots.size());
  state.balls.resize(balls.size());
  state.obstacles.resize(obstacles.size());
  state.rods.resize(rods.size());
  for (std::size_t i = 0; i < balls.size(); ++i) state.balls[i].spin = config.balls[i].spin;
  readState();
}

void World::Impl::watchMovers() {
  const FieldGeometry& field = config.field;
  approach.setOpen(units::length(field.length / 2 - field.corner),
                   units::length(field.width / 2 - field.corner));
  clearance.setField(units::length(field.length / 2), units::length(field.width / 2),
                     units::length(field.corner));
  for (const WallOutline& wall : wallOutlines(field, 0.0)) {
    approach.addWall(units::vector(wall[0]), units::vector(wall[3]));
    clearance.addWall(
        {units::vector(wall[0]), units::vector(wall[1]), units::vector(wall[2]), units::vector(wall[3])});
  }
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const RobotModel& model = config.robots[i].model;
    const float half_length = units::length(model.length / 2), half_width = units::length(model.width / 2);
    approach.addBox(robots[i].body, half_length, half_width);
    clearance.addBox(robots[i].body, half_length, half_width);
    contact_work.add(robots[i].body);
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const float radius = units::length(config.balls[i].model.radius);
    approach.addDisc(balls[i], radius);
    clearance.addDisc(balls[i], radius);
    contacts.squeeze().addBall(balls[i]);
    contact_work.add(balls[i]);
  }
  if (!obstacles.empty()) approach.setAlwaysContinuous();
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    if (config.obstacles[i].motion == ObstacleMotion::kPath)
      contacts_do_no_work = false;  // a moving obstacle does work
    if (config.obstacles[i].motion == ObstacleMotion::kPushable) contact_work.add(obstacles[i]);
  }
  for (const CarriedRod& rod : rods) contact_work.add(&rod.body());
  clearance_is_known = obstacles.empty() && rods.empty();
}

void World::Impl::driveRobots() {
  for (Robot& robot : robots) {
    b2Body& body = *robot.body;
    const BodyMotion change = robot.drive.step(motionOf(body), robot.push.expected());
    const Vec2 forward = direction(body), kick = forward * change.forward + perp(forward) * change.sideways;
    body.ApplyLinearImpulseToCenter(body.GetMass() * units::vector(kick), true);
    body.ApplyAngularImpulse(body.GetInertia() * static_cast<float>(change.yaw), true);
    robot.driven = body.GetLinearVelocity();
    robot.turned = body.GetAngularVelocity();
  }
}

// A rod's pulls are no contacts: mates that resisted them would drive each other apart.
void World::Impl::measurePushes() {
  if (!rods.empty()) return;
  for (Robot& robot : robots) {
    const b2Body& body = *robot.body;
    robot.push.measure(inFrame(body, robot.driven, robot.turned), motionOf(body));
  }
}

void World::Impl::rollBalls() {
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const BallModel& model = config.balls[i].model;
    const Vec2 velocity = units::metres(balls[i]->GetLinearVelocity());
    const BallMotion after = afterFloor(model, {velocity, state.balls[i].spin}, dt);
    const b2Vec2 kick = units::vector(after.velocity - velocity);
    balls[i]->ApplyLinearImpulseToCenter(balls[i]->GetMass() * kick, true);
    state.balls[i].spin = after.spin;
  }
}

void World::Impl::moveObstacles(double time) {
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    const ObstacleSpec& spec = config.obstacles[i];
    if (spec.motion == ObstacleMotion::kPath) followPath(spec, *obstacles[i], time, dt);
    if (spec.motion == ObstacleMotion::kPushable) applyFloorFriction(spec, *obstacles[i], dt);
  }
}

// Contacts change velocities. So with contacts, `clearance` can decide only once the engine has solved them,
// which is before it searches.
void World::Impl::planSearch(bool search, float part) {
  engine.SetContinuousPhysics(search);
  searches = search && clearance_is_known;
  if (!searches) return;
  clearance.remember(part);
  // If the last step solved contacts, this one probably does too: then `decideSearch` decides.
  if (!contacts.solved()) engine.SetContinuousPhysics(!clearance.isKeptFreely());
}

void World::Impl::decideSearch() {
  if (searches) engine.SetContinuousPhysics(!clearance.isKeptSolved());
  searches = false;  // later calls come from contacts within the search itself
}

// Whether two bodies may be near. The engine looks for near pairs at the end of a step, and also at the start
// if a body was placed.
bool World::Impl::isAnyPair() const { return !pairs_are_known || engine.GetContactCount() > 0; }

// Box2D's angle is a float that accumulates turns. Without wrapping, a robot that spins for minutes would
// lose precision of its heading. Also, from about 17 rad on, the C library's sinf and cosf, which Box2D
// calls, differ in the last bit for a few arguments on processors with fused multiply-add.
void World::Impl::unwindAngle(b2Body& body) {
  constexpr float kLargestAngle = 8.0f;
  if (std::abs(body.GetAngle()) < kLargestAngle) return;
  body.SetTransform(body.GetPosition(),
                    static_cast<float>(math::wrapAngle(static_cast<double>(body.GetAngle()))));
  pairs_are_known = false;
}

void World::Impl::collide() {
  const float least = static_cast<float>(dt / kMostParts);
  // Bodies that met in one part move differently in the next.
  for (float left = static_cast<float>(dt); left > 0.0f;) {
    const Approach::Plan plan = approach.plan(left);
    // The engine starts from the impulses of the last step, scaled up if this one is longer. That is right
    // for lasting forces but far too much for impacts. Jammed bodies need these impulses to stay apart, so
    // all parts of a step have equal length.
    float part = plan.share < 1.0f ? std::max(left / std::ceil(1.0f / plan.share), least) : left;
    if (left - part < least) part = left;
    engine.SetWarmStarting(part <= last_part);
    last_part = part;
    planSearch(plan.continuous, part);
    contacts.startPart();
    // Bodies that touch nothing need no iterations, and their energy does not change.
    const bool alone = !isAnyPair() && !engine.GetContinuousPhysics() && rods.empty();
    if (contacts_do_no_work && !alone) contact_work.remember();
    engine.Step(part, alone ? 0 : config.physics.velocity_iterations,
                alone ? 0 : config.physics.position_iterations);
    pairs_are_known = true;
    if (contacts_do_no_work && (contacts.solved() || !rods.empty())) contact_work.takeBack();
    if (contacts.solved() && contacts.squeeze().limit() && contacts_do_no_work) contact_work.takeBack();
    for (const Robot& robot : robots) unwindAngle(*robot.body);
    for (CarriedRod& rod : rods) rod.addImpulses();
    left -= part;
  }
}

void World::Impl::settleSpins() {
  for (const ContactLog::WallHit& hit : contacts.wallHits()) {
    Vec2& spin = state.balls[hit.ball].spin;
    spin = spinAfterWall(config.balls[hit.ball].model, spin, hit.normal);
  }
}

void World::Impl::stepOnce(double time) {
  contacts.startStep();
  driveRobots();
  rollBalls();
  moveObstacles(time);
  contacts.squeeze().startStep();
  collide();
  measurePushes();
  settleSpins();
}

void World::Impl::readState() {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const b2Body& body = *robots[i].body;
    const Vec2 velocity = units::metres(body.GetLinearVelocity());
    const double yaw = static_cast<double>(body.GetAngularVelocity());
    state.robots[i] = {poseOf(body), velocity, yaw,
                       robots[i].drive.encoders(dot(direction(body), velocity), yaw)};
  }
  for (std::size_t i = 0; i < balls.size(); ++i) {
    state.balls[i].position = units::metres(balls[i]->GetPosition());
    state.balls[i].velocity = units::metres(balls[i]->GetLinearVelocity());
  }
  const double time = static_cast<double>(state.tick) * config.physics.controlPeriod();
  for (std::size_t i = 0; i < obstacles.size(); ++i) {
    unwindAngle(*obstacles[i]);
    const bool on_path = config.obstacles[i].motion == ObstacleMotion::kPath;
    state.obstacles[i] = {poseOf(*obstacles[i]), on_path ? velocityAt(config.obstacles[i], time)
                                                         : units::metres(obstacles[i]->GetLinearVelocity())};
  }
  for (std::size_t i = 0; i < rods.size(); ++i) {
    unwindAngle(rods[i].body());
    state.rods[i] = rods[i].state(config.physics.controlPeriod());
  }
}

World::World(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

Result<World> World::create(const WorldConfig& config) {
  const FloatMode floats;
  keepEngineClockOut();
  if (auto checked = checkConfig(config); !checked) return tl::unexpected<Error>(checked.error());
  return World(std::make_unique<Impl>(config));
}

void World::step(std::span<const WheelSpeeds> commands) {
  const FloatMode floats;
  Impl& world = *impl_;
  const Tick tick = ++world.state.tick;
  world.contacts.startTick(tick);
  for (std::size_t i = 0; i < world.robots.size(); ++i) {
    world.robots[i].drive.setCommand(i < commands.size() ? commands[i] : WheelSpeeds{});
  }
  for (CarriedRod& rod : world.rods) rod.startTick();
  const int substeps = world.config.physics.substeps;
  const Tick steps_before = (tick - 1) * substeps;
  for (int i = 1; i <= substeps; ++i) world.stepOnce(static_cast<double>(steps_before + i) * world.dt);
  world.contacts.finishTick();
  world.readState();
}

const WorldState& World::state() const { return impl_->state; }
std::span<const ContactEvent> World::contacts() const { return impl_->contacts.events(); }
const WorldConfig& World::config() const { return impl_->config; }
float World::engineProfileMilliseconds() const { return impl_->engine.GetProfile().step; }

int World::touchingPairs() const {
  int count = 0;
  for (const b2Contact* c = impl_->engine.GetContactList(); c != nullptr; c = c->GetNext()) {
    count += c->IsTouching() ? 1 : 0;
  }
  return count;
}

}  // namespace fulbito
