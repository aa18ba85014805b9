#include "engine/sim/ball_motion.hpp"

#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

BallModel plainBall() {
  BallModel ball;
  ball.roll_keep = 0.6;
  ball.slide_deceleration = 3.0;
  ball.roll_deceleration = 0.1;
  ball.stop_speed = 0.01;
  ball.wall_spin_keep = 0.25;
  return ball;
}

}  // namespace

TEST_CASE("a sliding ball gives its speed to its spin in the fixed proportion", "[unit]") {
  const BallMotion after = afterFloor(plainBall(), {{1.0, 0.0}, {}}, 0.1);
  CHECK(after.velocity.x == Approx(0.7));
  CHECK(after.spin.x == Approx(0.3 * 0.6 / 0.4));
}

TEST_CASE("a ball whose spin and speed would cross in a step rolls from then on", "[unit]") {
  const BallMotion after = afterFloor(plainBall(), {{0.5, 0.0}, {0.0, 0.5}}, 1.0);
  CHECK(after.velocity == after.spin);
  // The direction is that of the mixture (0.3, 0.2); the speed is less by a second of rolling loss.
  CHECK(norm(after.velocity) == Approx(std::sqrt(0.13) - 0.1));
  CHECK(after.velocity.y / after.velocity.x == Approx(2.0 / 3.0));
}

TEST_CASE("a ball that rolls slowly rests", "[unit]") {
  const BallMotion after = afterFloor(plainBall(), {{0.0105, 0.0}, {0.0105, 0.0}}, 0.01);
  CHECK(after.velocity == Vec2{});
  CHECK(after.spin == Vec2{});
}

TEST_CASE("a ball that keeps all its speed and loses none rolls on for ever", "[unit]") {
  BallModel ball = plainBall();
  ball.roll_keep = 1.0;
  ball.roll_deceleration = 0.0;
  const BallMotion after = afterFloor(ball, {{0.3, 0.4}, {}}, 10.0);
  CHECK(after.velocity.x == Approx(0.3));
  CHECK(after.velocity.y == Approx(0.4));
}

TEST_CASE("a wall takes spin along its normal and leaves spin along itself", "[unit]") {
  const Vec2 spin = spinAfterWall(plainBall(), {0.8, 0.5}, {-1.0, 0.0});
  CHECK(spin.x == Approx(0.2));
  CHECK(spin.y == Approx(0.5));
}
