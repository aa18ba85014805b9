#include "engine/sim/steps/clearance.hpp"

#include <algorithm>
#include <memory>

#include <box2d/b2_circle_shape.h>
#include <box2d/b2_contact.h>
#include <box2d/b2_fixture.h>
#include <box2d/b2_polygon_shape.h>
#include <box2d/b2_time_of_impact.h>
#include <box2d/b2_world.h>

#include "engine/core/math/random.hpp"
#include "engine/sim/bodies.hpp"
#include "engine/sim/units.hpp"
#include "engine/sim/walls.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

using namespace fulbito;
using namespace fulbito::test;

namespace {

constexpr float kStep = 1.0f / 120.0f;  // [s]

/// A robot, a ball and walls with the engine's outlines, and the clearance of the three.
class RobotAndBall {
 public:
  explicit RobotAndBall(const FieldGeometry& field) {
    config_.field = field;
    config_.physics = standardPhysics();
    const RobotPreset preset = vsssPreset();
    walls_ = addWalls(engine_, config_, 0);
    robot_ = addRobot(engine_, config_, {preset.robot, {}, {}, 0.0}, 1);
    ball_ = addBall(engine_, config_, {preset.ball, {}, {}, {}}, 2);
    clearance_.setField(units::length(field.length / 2), units::length(field.width / 2),
                        units::length(field.corner));
    for (const WallOutline& wall : wallOutlines(field, 0.0)) {
      clearance_.addWall(
          {units::vector(wall[0]), units::vector(wall[1]), units::vector(wall[2]), units::vector(wall[3])});
    }
    clearance_.addBox(robot_, units::length(preset.robot.length / 2), units::length(preset.robot.width / 2));
    clearance_.addDisc(ball_, units::length(preset.ball.radius));
  }

  void place(Pose2 robot, Vec2 ball) {
    robot_->SetTransform(units::vector(robot.position), static_cast<float>(robot.heading));
    ball_->SetTransform(units::vector(ball), 0.0f);
  }
  void push(Vec2 robot, double spin, Vec2 ball) {
    robot_->SetLinearVelocity(units::vector(robot));
    robot_->SetAngularVelocity(static_cast<float>(spin));
    ball_->SetLinearVelocity(units::vector(ball));
  }

  /// Adds a fixed square that the clearance does not contain.
  void block(Vec2 middle, double half_side) {
    b2BodyDef body;
    body.position = units::vector(middle);
    b2PolygonShape square;
    const float half = units::length(half_side - units::kPolygonInset);
    square.SetAsBox(half, half);
    engine_.CreateBody(&body)->CreateFixture(&square, 0.0f);
  }

  /// The clearance's answer before the bodies move.
  bool isKeptAhead() {
    clearance_.remember(kStep);
    return clearance_.isKeptFreely();
  }
  /// Its answer when they have moved; afterwards they are back at their places.
  bool isKeptBehind() {
    clearance_.remember(kStep);
    const b2Sweep robot = sweep(*robot_), ball = sweep(*ball_);
    robot_->SetTransform(robot.c, robot.a);
    ball_->SetTransform(ball.c, 0.0f);
    const bool kept = clearance_.isKeptSolved();
    robot_->SetTransform(robot.c0, robot.a0);
    ball_->SetTransform(ball.c0, 0.0f);
    return kept;
  }
  /// One step of an engine that searches: the clearance's answer once contacts are solved, and whether the
  /// search found a contact of robot and ball.
  struct Step {
    bool kept = false;
    bool met = false;
  };
  Step step() {
    struct Listener : b2ContactListener {
      Clearance& clearance;
      Step seen;
      explicit Listener(Clearance& of) : clearance(of) {}
      void BeginContact(b2Contact* contact) override {
        seen.met |= contact->GetFixtureA()->GetBody()->GetType() == b2_dynamicBody &&
                    contact->GetFixtureB()->GetBody()->GetType() == b2_dynamicBody;
      }
      void PostSolve(b2Contact*, const b2ContactImpulse*) override {
        if (!seen.met) seen.kept = clearance.isKeptSolved();
      }
    } listener(clearance_);
    engine_.SetContactListener(&listener);
    clearance_.remember(kStep);
    engine_.Step(kStep, 8, 3);
    engine_.SetContactListener(nullptr);
    return listener.seen;
  }
  /// Whether the engine's own search finds a contact.
  bool findsContact() const {
    bool found = touch(*robot_, *robot_->GetFixtureList(), *ball_->GetFixtureList());
    for (const b2Fixture* wall = walls_->GetFixtureList(); wall != nullptr; wall = wall->GetNext()) {
      found = found || touch(*robot_, *robot_->GetFixtureList(), *wall) ||
              touch(*ball_, *ball_->GetFixtureList(), *wall);
    }
    return found;
  }

 private:
  static b2Sweep sweep(const b2Body& body) {
    b2Sweep way;
    way.localCenter.SetZero();
    way.c0 = body.GetPosition(), way.a0 = body.GetAngle();
    way.c = way.c0 + kStep * body.GetLinearVelocity();
    way.a = way.a0 + kStep * body.GetAngularVelocity();
    way.alpha0 = 0.0f;
    return way;
  }
  static bool touch(const b2Body& body, const b2Fixture& a, const b2Fixture& b) {
    b2TOIInput input;
    input.proxyA.Set(a.GetShape(), 0);
    input.proxyB.Set(b.GetShape(), 0);
    input.sweepA = sweep(body);
    input.sweepB = sweep(*b.GetBody());
    input.tMax = 1.0f;
    b2TOIOutput output;
    b2TimeOfImpact(&output, &input);
    return output.state == b2TOIOutput::e_touching;
  }

  WorldConfig config_;
  b2World engine_{b2Vec2{0.0f, 0.0f}};
  b2Body* walls_ = nullptr;
  b2Body* robot_ = nullptr;
  b2Body* ball_ = nullptr;
  Clearance clearance_{true};
};

Vec2 drawn(Rng& random, double x, double y) { return {random.uniform(-x, x), random.uniform(-y, y)}; }

}  // namespace

TEST_CASE("what keeps clear of walls and balls is what the engine finds no contact of", "[unit]") {
  FieldGeometry square;
  square.corner = 0.0;
  FieldGeometry closed;
  closed.goal_width = closed.goal_depth = 0.0;
  const FieldGeometry field = GENERATE_COPY(FieldGeometry{}, square, closed);
  const bool near_ball = GENERATE(true, false);
  CAPTURE(field.corner, field.goal_depth, near_ball);
  RobotAndBall scene(field);
  Rng random(7, Stream{6});
  const double half_x = field.length / 2 + field.goal_depth, half_y = field.width / 2;
  int missed = 0, found = 0, kept = 0, free = 0;
  for (int i = 0; i < 30000; ++i) {
    const Pose2 robot{drawn(random, half_x, half_y), random.uniform(-math::kPi, math::kPi)};
    const Vec2 ball =
        near_ball ? robot.position + drawn(random, 0.075, 0.075) : drawn(random, half_x, half_y);
    scene.place(robot, ball);
    const double fast = i % 2 == 0 ? 8.0 : 0.5;
    scene.push(drawn(random, 2.0, 2.0), random.uniform(-40.0, 40.0), drawn(random, fast, fast));
    const bool contact = scene.findsContact(), ahead = scene.isKeptAhead(), behind = scene.isKeptBehind();
    missed += contact && (ahead || behind) ? 1 : 0;
    found += contact ? 1 : 0;
    free += contact ? 0 : 1;
    kept += !contact && ahead && behind ? 1 : 0;
  }
  CHECK(missed == 0);
  CHECK(found > 500);
  CAPTURE(kept, free);
  CHECK(kept > free / 4);
}

TEST_CASE("a body that its contacts hold where it is stays in the way", "[unit]") {
  constexpr double kGap = 0.0002;  // [m] near enough to touch, and too far to be moved apart
  constexpr double kHalfBlock = 0.05;
  RobotAndBall scene{FieldGeometry{}};
  const RobotPreset preset = vsssPreset();
  const Vec2 robot{-preset.robot.length / 2 - preset.ball.radius - 0.03, 0.0};
  scene.place({robot, 0.0}, {});
  scene.block({preset.ball.radius + kGap + kHalfBlock, 0.0}, kHalfBlock);
  // The robot comes 3 mm too far for a ball at rest, but not for one that rolls away.
  scene.push({0.033 / static_cast<double>(kStep), 0.0}, 0.0, {1.0, 0.0});
  const auto step = scene.step();
  CHECK(step.met);
  CHECK_FALSE(step.kept);
}
