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

}  // namespace fulbito
