#include "strategies/teams/libero/attack/aim.hpp"

#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// The y at which libero aims on the line of an empty goal, with a ball at (0.6, 0.35) of this velocity.
double aimedAt(Vec2 velocity, const libero::Pitch& pitch) {
  Observation seen;
  seen.ball.position = {0.6, 0.35};
  seen.ball.velocity = velocity;
  libero::BallForecast ball;
  ball.take(seen.ball, {});
  const libero::Picture picture{seen, pitch, ball};
  return libero::openMouth(picture, seen.ball.position, 0.4, 0.0);
}

}  // namespace

TEST_CASE("libero aims where a ball that rolls at the goal already goes", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  CHECK(aimedAt({}, pitch) == 0.0);
  // The ball reaches the line at 0.10 m.
  CHECK(std::abs(aimedAt({0.3, -0.5}, pitch) - 0.10) < 1e-9);
  // The ball would pass the post, so the aim is as near to the post as is safe for a ball that comes
  // slanting.
  const double past = aimedAt({0.5, -0.5}, pitch);
  CHECK(past > 0.1);
  const Vec2 way = Vec2{pitch.half_length, past} - Vec2{0.6, 0.35};
  CHECK((pitch.goal_half - past) * way.x / norm(way) > pitch.ball_radius + pitch.tuning.clearance);
  // A ball that rolls away from the goal has no influence.
  CHECK(aimedAt({-0.5, -0.5}, pitch) == 0.0);
}

// A robot that turned to aim at the goal would let go of a ball that it has pushed to the post.
TEST_CASE("libero pushes a ball along the end wall until it is in front of the mouth", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  const Vec2 target{pitch.half_length + pitch.ball_radius, 0.0};
  const double at_wall = pitch.half_length - pitch.ball_radius;
  for (const double y : {0.5, 0.3, 0.21}) {
    const libero::Aim aim = libero::aimAt(pitch, {at_wall, y}, target);
    CHECK(aim.wall);
    CHECK(aim.direction.y < -0.9);
  }
  CHECK_FALSE(libero::aimAt(pitch, {at_wall, 0.19}, target).wall);
  // Off the wall by half a robot, one fits behind the ball.
  CHECK_FALSE(libero::aimAt(pitch, {at_wall - pitch.robot_half, 0.3}, target).wall);
}

}  // namespace fulbito
