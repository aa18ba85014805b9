#include "strategies/prediction/ball_walls.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "strategies/prediction/ball_prediction.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/draws.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

/// Whether a ball with its centre at `p` is at most 3 mm in any wall or post: on the playing rectangle, in a
/// goal, or in a mouth between the two.
bool isClear(const MatchInfo& info, Vec2 p) {
  const FieldGeometry& field = info.field;
  const double room = info.ball.radius - 0.003;
  if (insideField(field, p, room)) return true;
  const double x = std::abs(p.x), y = std::abs(p.y);
  return y < field.goal_width / 2 && x < field.length / 2 &&
         distance({x, y}, {field.length / 2, field.goal_width / 2}) >= room;
}

}  // namespace

TEST_CASE("the time of a fall is the first passage through zero", "[unit]") {
  CHECK(*timeOfFall(1.0, -2.0, 0.0, 1.0) == Approx(0.5));
  CHECK(*timeOfFall(1.0, 1.0, -4.0, 2.0) == Approx(1.0));
  CHECK(*timeOfFall(0.0, -1.0, 0.0, 1.0) == 0.0);
  CHECK(*timeOfFall(-0.001, -1.0, 0.0, 1.0) == 0.0);
  CHECK_FALSE(timeOfFall(1.0, -2.0, 0.0, 0.4));
  CHECK_FALSE(timeOfFall(1.0, -1.0, 1.0, 9.0));  // it turns back first
  CHECK_FALSE(timeOfFall(1.0, 1.0, 0.0, 9.0));
}

TEST_CASE("a predicted ball stays on the field, corners and posts included", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallCourse course(info.field, info.ball, info.physics);
  Rng rng(8, test::kTestStream);
  int in_goal = 0;
  for (int i = 0; i < 3000; ++i) {
    BallState ball;
    do {
      ball.position = {rng.uniform(-0.75, 0.75), rng.uniform(-0.65, 0.65)};
    } while (!course.walls.isFree(ball.position));
    ball.velocity = test::drawVector(rng, 0.0, 3.0);
    ball.spin = test::drawVector(rng, 0.0, 2.0);
    BallPrediction prediction;
    prediction.predict(course, ball);
    for (double t = 0.0; t < 3.5; t += 0.05) {
      const Vec2 p = prediction.positionAt(t);
      if (!isClear(info, p)) {
        CAPTURE(i, t, p.x, p.y);
        FAIL_CHECK("the ball is in a wall");
      }
      in_goal += std::abs(p.x) > info.field.length / 2;
    }
  }
  CHECK(in_goal > 100);
}

TEST_CASE("a ball on a bent way meets what its chord passes by", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallCourse course(info.field, info.ball, info.physics);
  const double wall = info.field.width / 2 - info.ball.radius;
  struct Scene {
    BallState ball;
    double until;  // [s]
  };
  const Scene scenes[] = {// Sidespin bends the way into the goal's side wall, a post, a post from the side.
                          {{{-0.59388, -0.05457}, {-1.39425, 2.25852}, {-0.42523, -1.58413}}, 0.3},
                          {{{-0.70370, 0.02599}, {-0.43150, -2.35402}, {1.42177, 0.42475}}, 0.3},
                          {{{-0.28024, -0.33089}, {-1.76738, 2.27849}, {-0.79250, -1.65234}}, 0.5},
                          // The ball leaves a post with spin toward it.
                          {{{0.4959289092504795, 0.03041831854301924},
                            {1.9227620324496568, 1.4171300960774715},
                            {-0.14876151646460656, -1.405822064977879}},
                           0.5},
                          // Backspin reverses the ball just after it has reached the wall.
                          {{{0.0, wall - 0.0001}, {0.0, 0.2}, {0.0, -2.0}}, 0.3}};
  for (const Scene& scene : scenes) {
    BallPrediction prediction;
    prediction.predict(course, scene.ball);
    CAPTURE(scene.ball.position.x, scene.ball.position.y);
    CHECK(prediction.bouncesBefore(scene.until) >= 1);
    CHECK(prediction.bouncesBefore(3.0) < 20);
    int in_wall = 0;
    for (double t = 0.0; t < 1.0; t += 0.005) in_wall += isClear(info, prediction.positionAt(t)) ? 0 : 1;
    CHECK(in_wall == 0);
  }
}

TEST_CASE("a ball that passes a post is told from one that meets it", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallWalls walls(info.field, info.ball.radius);
  const Vec2 post{info.field.length / 2, info.field.goal_width / 2};
  Rng rng(6, test::kTestStream);
  int met = 0, passed = 0;
  for (int run = 0; run < 4000; ++run) {
    // Straight and bent ways close to the post, from the field.
    EvenMotion motion;
    motion.position = post - Vec2{rng.uniform(0.03, 0.2), rng.uniform(-0.1, 0.1)};
    const Vec2 toward = post + test::drawVector(rng, 0.0, 2.0 * info.ball.radius);
    motion.velocity = unitOr(toward - motion.position, {1.0, 0.0}) * rng.uniform(0.1, 1.5);
    motion.acceleration = test::drawVector(rng, 0.0, run % 2 == 0 ? 0.0 : 1.0);
    constexpr double kDuration = 0.4;
    const auto hit = walls.firstHit(motion, kDuration);
    const double until = hit ? hit->time : kDuration;
    double nearest = 1.0;
    for (int i = 0; i <= 1000; ++i)
      nearest = std::min(nearest, distance(motion.positionAt(until * i / 1000), post));
    CAPTURE(run, motion.position, motion.velocity, motion.acceleration, until);
    REQUIRE(nearest > info.ball.radius - 5e-5);
    ++(hit && nearest < info.ball.radius + 2e-5 ? met : passed);
  }
  CHECK(met > 500);
  CHECK(passed > 500);
}

TEST_CASE("a ball on a post comes back", "[unit]") {
  const MatchInfo info = test::matchInfo();
  const BallCourse course(info.field, info.ball, info.physics);
  const Vec2 velocity{1.0, 0.0};
  BallPrediction prediction;
  prediction.predict(course, {{0.4, info.field.goal_width / 2}, velocity, velocity});
  CHECK(prediction.bouncesBefore(2.0) >= 1);
  CHECK(prediction.positionAt(0.4).x < info.field.length / 2 - info.ball.radius + 1e-9);
  CHECK(prediction.velocityAt(0.5).x < 0.0);
}

}  // namespace fulbito
