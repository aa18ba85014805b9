#include "strategies/teams/libero/defence/goal_line.hpp"

#include <cmath>

#include "engine/core/math/random.hpp"
#include "engine/core/models/field_places.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/teams/libero/driven.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero's keeper knows where a ball crosses its line", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  const BallCourse course(info.field, info.ball, info.physics);
  const double line = -pitch.half_length + 0.05;
  Rng rng(1, test::kTestStream);
  int crossings = 0;
  for (int run = 0; run < 600; ++run) {
    Observation seen;
    seen.ball.position = {rng.uniform(-0.6, 0.5), rng.uniform(-0.4, 0.4)};
    seen.ball.velocity = math::unit(rng.uniform(-math::kPi, math::kPi)) * rng.uniform(0.3, 1.5);
    seen.ball.spin = seen.ball.velocity;
    BallPrediction way;
    way.predict(course, seen.ball);
    libero::BallForecast ball;
    ball.take(seen.ball, way);
    const auto found = libero::crossing({seen, pitch, ball}, line);
    const auto exact = way.crossing({line, 0.0}, {-1.0, 0.0});
    CAPTURE(run);
    // Beside the goal, a ball may cross the line and return between two steps of the forecast.
    const bool enters = exact && exact->time < 1.15 && std::abs(exact->place.y) < pitch.goal_half - 0.03;
    if (enters) {
      REQUIRE(found);
      // A bounce between two steps of the forecast shortens the path.
      CHECK(*found == Approx(exact->place.y).margin(0.03));
      ++crossings;
    } else if (!exact) {
      CHECK_FALSE(found);
    }
  }
  CHECK(crossings > 20);
}

// The striker comes home at full speed, and slides. The keeper turns slowly, and must not run out at a ball
// that rolls past it.
TEST_CASE("a saved shot that rolls about in front of libero's goal seldom goes in", "[unit]") {
  struct Shot {
    Vec2 ball, velocity;
    double keeper;
    Pose2 striker;
  };
  const Shot shots[] = {
      {{0.5340, -0.4166}, {-1.8880, 0.5778}, -0.0178, {{0.5508, 0.5278}, -2.9267}},
      {{0.1345, 0.0611}, {-1.2045, -0.1714}, 0.0038, {{0.6461, -0.5002}, 0.6757}},
      {{0.5643, 0.5103}, {-1.7288, -0.4480}, 0.0214, {{0.6142, -0.5059}, 2.0588}},
      {{0.5313, -0.0468}, {-1.9869, 0.0896}, -0.0020, {{0.6395, -0.4695}, -0.5179}},
      {{0.4430, -0.5663}, {-1.8013, 0.6200}, -0.0261, {{0.6267, 0.5498}, -0.5857}},
      {{0.6653, 0.5151}, {-1.8733, -0.4595}, 0.0200, {{0.6137, -0.4635}, -1.2366}},
      {{0.4843, -0.6242}, {-1.8250, 0.6855}, -0.0278, {{0.6015, 0.4568}, 2.7398}},
      {{0.5856, -0.5524}, {-1.7948, 0.6404}, -0.0227, {{0.5631, 0.5301}, -3.0229}},
  };
  int conceded = 0;
  for (const Shot& shot : shots) {
    for (int run = 0; run < 9; ++run) {
      Placement scene;
      scene.ball = shot.ball;
      scene.ball_velocity = shot.velocity;
      scene.robots[0] = {
          Pose2{{-0.695, shot.keeper}, math::kPi / 2},
          Pose2{shot.striker.position + Vec2{run % 3 - 1.0, run / 3 - 1.0} * 0.01, shot.striker.heading}};
      conceded += test::playedFrom(scene, 2.0, "idle", "firasim").referee().score[1];
    }
  }
  CAPTURE(conceded);
  CHECK(conceded <= 12);
}

TEST_CASE("libero's keeper stands nearer to the post that a pushed ball reaches sooner", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  const BallCourse course(info.field, info.ball, info.physics);
  // How far it stands from the place with equal gaps to both posts, toward the ball's side.
  const auto shift = [&](double y, double speed) {
    Observation seen;
    seen.ball.position = {-0.45, y};
    seen.ball.velocity = seen.ball.spin = {speed, 0.0};
    BallPrediction way;
    way.predict(course, seen.ball);
    libero::BallForecast ball;
    ball.take(seen.ball, way);
    const double even = equalGapPoint(pitch.field, ball.sample(1), libero::keeperDepth(pitch)).y;
    return (libero::evenRestPlace({seen, pitch, ball}) - even) * (y < 0.0 ? -1.0 : 1.0);
  };
  CHECK(shift(0.0, 0.0) == Approx(0.0).margin(1e-12));
  for (const double y : {0.05, 0.15, 0.3}) {
    CAPTURE(y);
    CHECK(shift(y, 0.0) > 0.0);
    CHECK(shift(-y, 0.0) == Approx(shift(y, 0.0)).margin(1e-12));
    // A ball from rest gives the keeper the way that one post is nearer, halved; a fast ball gives less.
    const double near = distance({-0.45, y}, {-pitch.half_length, pitch.goal_half});
    const double far = distance({-0.45, y}, {-pitch.half_length, -pitch.goal_half});
    CHECK(shift(y, 0.0) < (far - near) / 2 + 0.01);
    CHECK(shift(y, 0.8) < shift(y, 0.0));
  }
}

TEST_CASE("libero's keeper slides along its line and stops where it should", "[unit]") {
  const MatchInfo info = test::infoOf(3);
  const libero::Pitch pitch(info);
  const libero::BallForecast ball;
  const double line = -pitch.half_length + 0.042;
  Observation seen;
  seen.ball.position = {0.5, 0.0};
  const libero::Picture picture{seen, pitch, ball};
  Rng rng(2, test::kTestStream);
  for (int run = 0; run < 100; ++run) {
    RobotState keeper;
    const double side = run % 2 == 0 ? 1.0 : -1.0;
    keeper.pose = {{line, rng.uniform(-0.17, 0.17)}, side * math::kPi / 2};
    const double y = rng.uniform(-0.17, 0.17);
    const bool up = y > keeper.pose.position.y;
    double farthest = 0.0, past = 0.0;
    for (int tick = 0; tick < 90; ++tick) {
      keeper = test::driven(info, keeper, libero::slideTo(picture, keeper, line, y));
      farthest = std::max(farthest, std::abs(keeper.pose.position.x - line));
      past = std::max(past, (keeper.pose.position.y - y) * (up ? 1.0 : -1.0));
    }
    CAPTURE(run);
    CHECK(farthest < 0.01);
    CHECK(past < 0.01);
    CHECK(keeper.pose.position.y == Approx(y).margin(0.005));
  }
}

TEST_CASE("libero's keeper closes the end wall between ball and goal", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  for (const double side : {1.0, -1.0}) {
    const auto closes = [&](Vec2 self, double ball) {
      Observation seen;
      seen.team_size = 3;
      seen.own[0] = test::standingAt({{self.x, side * self.y}, 0.0});
      seen.ball.position = {-0.728, side * ball};
      libero::BallForecast forecast;
      forecast.take(seen.ball, {});
      return libero::closesEndWall({seen, pitch, forecast}, seen.own[0].state);
    };
    CHECK(closes({-0.70, 0.3}, 0.4));
    CHECK_FALSE(closes({-0.60, 0.3}, 0.4));  // off the wall
    CHECK_FALSE(closes({-0.70, 0.4}, 0.4));  // beside the ball
    CHECK_FALSE(closes({-0.70, 0.5}, 0.4));  // the ball is nearer to the goal
    CHECK(closes({-0.70, -0.1}, 0.4));
  }
}

}  // namespace fulbito
