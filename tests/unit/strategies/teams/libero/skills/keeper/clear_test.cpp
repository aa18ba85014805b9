#include "fulbito/detail/math.hpp"
#include "strategies/prediction/time_to_reach.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/keeper/keeper_at.hpp"

namespace fulbito {

TEST_CASE("libero's keeper clears a ball that lies beside its goal, though two wait for it", "[unit]") {
  Placement scene;
  scene.ball = {-0.688, 0.225};
  scene.robots[0] = {Pose2{{-0.70, 0.17}, math::kPi / 2}, Pose2{{0.2, 0.3}, 0.0}, Pose2{{0.2, -0.3}, 0.0}};
  scene.robots[1] = {Pose2{{-0.50, 0.30}, 0.0}, Pose2{{-0.50, 0.42}, 0.0}};
  const Match match = test::playedFrom(scene, 1.0);
  CHECK(distance(match.world().balls[0].position, scene.ball) > 0.15);
  CHECK(match.referee().score[1] == 0);
}

TEST_CASE("libero's keeper clears a ball that creeps off it, though two wait for it", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.645, -0.079};
    scene.ball_velocity = {0.11, -0.07};
    scene.robots[0] = {test::keeperAt({-0.745, -0.077}, side), Pose2{{-0.25, -0.45}, 0.0},
                       Pose2{{-0.25, 0.3}, 0.0}};
    scene.robots[1] = {Pose2{{-0.445, -0.25}, 0.0}, Pose2{{-0.369, 0.085}, 0.0}};
    scene = test::mirrored(scene, side);
    const Match match = test::playedFrom(scene, 1.0);
    CHECK(distance(match.world().balls[0].position, scene.ball) > 0.2);
    CHECK(match.referee().score[1] == 0);
  }
}

TEST_CASE("a keeper that speeds up slowly clears only what it reaches a turn before any opponent", "[unit]") {
  // How much sooner [s] than the nearest opponent that it dares the keeper is at a ball in front of it.
  const auto lead = [](const char* robot) {
    const MatchInfo info = test::infoOf(3, robot);
    const libero::Pitch pitch(info);
    Observation seen;
    seen.team_size = 3;
    seen.ball.position = {-0.58, 0.0};
    seen.own[0] = test::standingAt({{-0.69, 0.0}, math::kPi / 2});
    libero::BallForecast ball;
    ball.take(seen.ball, {});
    const double needed = timeToReach(pitch.pace, seen.own[0].state, seen.ball.position);
    for (double off = 0.1; off < 1.0; off += 0.01) {
      seen.opponents[1] = test::standingAt({{-0.58 + off, 0.0}, math::kPi});
      libero::Picture picture{seen, pitch, ball};
      picture.keeper = 0;
      libero::Memory memory;
      if (libero::keeper::clear(picture, 0, memory))
        return timeToReach(pitch.pace, seen.opponents[1].state, seen.ball.position) - needed;
    }
    return 0.0;
  };
  const double turn = libero::Pitch(test::infoOf(3, "firasim")).turn_time;
  CHECK(lead("firasim") == Approx(turn).margin(0.02));
  CHECK(lead("vsss") == Approx(0.0).margin(0.02));
}

TEST_CASE("libero's keeper goes out to a ball that creeps along its end wall", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    for (const char* opponent : {"chaser", "classic"}) {
      CAPTURE(side, opponent);
      Placement scene;
      scene.ball = {-0.728, -0.446};
      scene.ball_velocity = {0.0, 0.21};
      scene.robots[0] = {test::keeperAt({-0.708, -0.173}, side), Pose2{{-0.46, -0.245}, 0.0}};
      scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.70, -0.56}, -1.15}};
      const Match match = test::playedFrom(test::mirrored(scene, side), 0.5, opponent);
      // The keeper has met the ball outside its post, and the opponent has not passed.
      CHECK(side * match.world().robots[0].pose.position.y < -0.30);
      CHECK(side * match.world().balls[0].position.y < -0.35);
    }
  }
}

namespace {

/// The move of a keeper at `self` [m] in its half of the end wall, for a ball at `ball` [m]. On the side -1
/// everything is mirrored.
std::optional<libero::Move> clears(double side, Vec2 self, Vec2 ball, std::optional<Vec2> opponent = {}) {
  const libero::Pitch pitch(test::infoOf(3));
  Observation seen;
  seen.team_size = 3;
  seen.own[0] = test::standingAt({{self.x, side * self.y}, side * math::kPi / 2});
  if (opponent)
    seen.opponents[1] = test::standingAt({{opponent->x, side * opponent->y}, -side * math::kPi / 2});
  seen.ball.position = {ball.x, side * ball.y};
  libero::BallForecast forecast;
  forecast.take(seen.ball, {});
  libero::Memory memory;
  return libero::keeper::clear({seen, pitch, forecast}, 0, memory);
}

}  // namespace

TEST_CASE("libero's keeper stays at a ball in the corner that it has met", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CHECK(clears(side, {-0.708, 0.45}, {-0.728, 0.52}));
    CHECK_FALSE(clears(side, {-0.708, 0.3}, {-0.728, 0.52}));   // it has not met this one
    CHECK_FALSE(clears(side, {-0.708, 0.58}, {-0.728, 0.52}));  // the ball is behind it
  }
}

TEST_CASE("in large matches libero's keeper sets off for the place where it meets a ball along the wall",
          "[unit]") {
  for (const double side : {1.0, -1.0}) {
    for (const int team_size : {3, 5}) {
      const libero::Pitch pitch(test::infoOf(team_size));
      const double post = pitch.goal_half - pitch.ball_radius,
                   far = pitch.area_half + pitch.field.goal_area_depth;
      const auto goesTo = [&](double y, double coming) {
        Observation seen;
        seen.team_size = team_size;
        seen.own[0] = test::standingAt({{-pitch.half_length + pitch.front, post * side}, math::kPi / 2});
        seen.ball.position = {-pitch.half_length + pitch.ball_radius, y * side};
        seen.ball.velocity = {0.0, -coming * side};
        libero::BallForecast forecast;
        forecast.take(seen.ball, {});
        libero::Memory memory;
        return libero::keeper::clear({seen, pitch, forecast}, 0, memory).has_value();
      };
      CAPTURE(side, team_size);
      CHECK(goesTo(far - 0.01, 0.0));
      CHECK(goesTo(far - 0.01, 1.0));
      CHECK_FALSE(goesTo(far + 0.01, 0.0));
      CHECK(goesTo(far + 0.05, 1.0) == pitch.isLarge());
      // By the formula: the gap closes in 0.2 s, in which the ball comes 0.2 m.
      CHECK_FALSE(goesTo(far + 0.3, 1.0));
    }
  }
}

TEST_CASE("libero's keeper turns its face to the field against a ball that is pushed at it", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    const Vec2 self{-0.708, 0.3}, ball{-0.728, 0.36};
    const auto pushed = clears(side, self, ball, Vec2{-0.71, 0.42});
    const auto alone = clears(side, self, ball);
    REQUIRE(pushed);
    REQUIRE(alone);
    CHECK(side * pushed->twist.angular < -1.0);
    CHECK(side * alone->twist.angular > -1.0);
    CHECK(pushed->twist.linear > 1.0);
  }
}

TEST_CASE("libero's keeper leaves balls in the corner to the others", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    for (const char* robot : {"vsss", "firasim"}) {
      const libero::Pitch pitch(test::infoOf(3, robot));
      const auto clears = [&](double y) {
        Observation seen;
        seen.team_size = 3;
        seen.own[0] = test::standingAt({{-0.708, 0.3 * side}, math::kPi / 2});
        seen.ball.position = {-0.728, y * side};
        libero::BallForecast forecast;
        forecast.take(seen.ball, {});
        libero::Memory memory;
        return libero::keeper::clear({seen, pitch, forecast}, 0, memory).has_value();
      };
      CHECK(clears(0.45));
      CHECK_FALSE(clears(0.52));
    }
  }
}

}  // namespace fulbito
