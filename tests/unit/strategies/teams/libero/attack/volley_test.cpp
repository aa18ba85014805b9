#include "strategies/teams/libero/attack/volley.hpp"

#include <algorithm>
#include <cmath>

#include "fulbito/detail/math.hpp"
#include "strategies/prediction/foresight.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// A ball that rolls across in front of a robot at rest.
struct Crossing {
  explicit Crossing(double side, Vec2 velocity = {0.05, -0.5}, Vec2 from = {0.42, 0.3})
      : info(test::infoOf(3, "firasim")) {
    seen.team_size = 3;
    seen.own[1] = test::standingAt({{0.05, -0.35 * side}, 0.0});
    seen.ball.position = {from.x, from.y * side};
    seen.ball.velocity = seen.ball.spin = {velocity.x, velocity.y * side};
    BallPrediction way;
    way.predict(BallCourse(info.field, info.ball, info.physics), seen.ball);
    ball.take(seen.ball, way);
  }

  libero::Picture picture() const { return {seen, pitch, ball}; }

  MatchInfo info;
  libero::Pitch pitch{info};
  Observation seen;
  libero::BallForecast ball;
};

}  // namespace

TEST_CASE("a hit adds bounce along the face and friction across it, and spin keeps a share", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3, "firasim"));
  // A ball that rests, hit straight on: a heavy robot gives it its own speed and the restitution.
  const libero::Hit straight = libero::hitOf(pitch, {}, {1.0, 0.0}, 0.8);
  CHECK(std::abs(straight.leaves.x - 0.8 * 1.07 * 2.40 / 2.443) < 1e-9);
  CHECK(std::abs(straight.rolls.x - 0.70 * straight.leaves.x) < 1e-9);
  CHECK(straight.leaves.y == 0.0);
  // A ball that rolls across keeps its way, less the friction, which never reverses it.
  const libero::Hit across = libero::hitOf(pitch, {0.0, -0.5}, {1.0, 0.0}, 0.8);
  CHECK(std::abs(across.leaves.x - straight.leaves.x) < 1e-9);
  CHECK(across.leaves.y > -0.5);
  CHECK(across.leaves.y < -0.3);
  CHECK(across.rolls.y < across.leaves.y);
  CHECK(libero::hitOf(pitch, {0.0, -0.01}, {1.0, 0.0}, 0.8).leaves.y == 0.0);
  // A ball that runs ahead faster is not touched.
  CHECK(libero::hitOf(pitch, {0.9, 0.0}, {1.0, 0.0}, 0.8).leaves.x == 0.9);
}

TEST_CASE("libero finds a run that sends a crossing ball in, on either side", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    const Crossing scene(side);
    const auto run = libero::bestVolley(scene.picture(), 1);
    REQUIRE(run);
    CHECK(run->room > 0.0);
    CHECK(std::abs(run->target.y) < scene.pitch.goal_half - scene.pitch.ball_radius);
    CHECK(std::abs(run->target.x - scene.pitch.half_length) < 1e-6);
    const Vec2 way = run->ball - scene.seen.own[1].state.pose.position;
    CHECK(std::abs(run->heading - math::angleOf(way)) < 1e-12);
    CHECK(run->spare > -libero::BallForecast::kStep);
    CHECK(std::abs(run->target.y - (side * libero::bestVolley(Crossing(1.0).picture(), 1)->target.y)) < 1e-9);
  }
}

TEST_CASE("a volley's ball goes where the prediction of the struck ball does", "[unit]") {
  const Crossing scene(1.0);
  const auto run = libero::bestVolley(scene.picture(), 1);
  REQUIRE(run);
  const Vec2 way = run->ball - scene.seen.own[1].state.pose.position;
  const Vec2 rolling = (scene.ball.at(run->time + 0.05) - run->ball) / 0.05;
  const double speed = std::sqrt(2 * scene.pitch.acceleration * (norm(way) - scene.pitch.front));
  const libero::Hit hit = libero::hitOf(scene.pitch, rolling, way / norm(way), speed);
  BallPrediction struck;
  struck.predict(BallCourse(scene.info.field, scene.info.ball, scene.info.physics),
                 {run->ball, hit.leaves, rolling});
  const auto goal = struck.crossing({scene.pitch.half_length, 0.0}, {1.0, 0.0});
  REQUIRE(goal);
  CHECK(std::abs(goal->place.y - run->target.y) < 0.005);
}

TEST_CASE("libero shoots past an opponent in the way of its volley, or not at all", "[unit]") {
  Crossing scene(1.0);
  const auto free = libero::bestVolley(scene.picture(), 1);
  REQUIRE(free);
  // A keeper where the ball would arrive.
  scene.seen.opponents[0] = test::standingAt({{0.71, free->target.y}, math::kPi / 2});
  const auto kept = libero::bestVolley(scene.picture(), 1);
  CHECK((!kept || kept->room < free->room));
  if (kept) CHECK(std::abs(kept->target.y - free->target.y) > scene.pitch.front);
  // Opponents all along the goal leave no room.
  for (const int i : {0, 1, 2})
    scene.seen.opponents[static_cast<std::size_t>(i)] = test::standingAt({{0.71, 0.12 * (i - 1)}, 0.0});
  CHECK_FALSE(libero::bestVolley(scene.picture(), 1));
}

TEST_CASE("libero shoots where an opponent's face may just reach the ball's way, but not its middle",
          "[unit]") {
  int narrow = 0;
  for (double y = -0.15; y < 0.16; y += 0.01) {
    Crossing scene(1.0, {0.0, -0.53});
    scene.seen.opponents[0] = test::standingAt({{0.71, y}, math::kPi / 2});
    // Alone against a keeper it waits for a gap.
    const auto alone = libero::bestVolley(scene.picture(), 1);
    if (alone) CHECK(alone->room > 0.0);
    scene.seen.opponents[1] = test::standingAt({{0.44, 0.40}, math::kPi});
    const auto run = libero::bestVolley(scene.picture(), 1);
    if (!run) continue;
    CHECK(run->room > libero::leastRoom(scene.picture()));
    CHECK(std::abs(run->target.y - y) > scene.pitch.ball_radius);
    narrow += run->room < 0.0 ? 1 : 0;
  }
  CHECK(narrow > 0);
}

TEST_CASE("libero shoots a thrown free ball although opponents could get into its way", "[unit]") {
  int reached = 0;
  for (double y = -0.30; y < 0.31; y += 0.05) {
    // Both takers of a free ball have thrown it: it crosses farther from the goal, and flies longer.
    Crossing scene(1.0, {-0.05, -0.5}, {0.34, 0.3});
    scene.seen.restart = RestartKind::kFreeBall;
    scene.seen.since_restart = 1.0;
    scene.seen.opponents[1] = test::standingAt({{0.50, y - 0.05}, math::kPi});
    scene.seen.opponents[2] = test::standingAt({{0.50, y + 0.05}, math::kPi});
    const auto run = libero::bestVolley(scene.picture(), 1);
    REQUIRE(run);
    reached += run->room < -scene.pitch.front ? 1 : 0;
    // In play, such a ball is left to others.
    scene.seen.since_restart = 10.0;
    const auto later = libero::bestVolley(scene.picture(), 1);
    if (later) CHECK(later->room > -scene.pitch.front);
  }
  CHECK(reached > 0);
}

TEST_CASE("libero's volley of a free ball goes at most as far beside as one that touches the post",
          "[unit]") {
  for (const bool thrown : {true, false}) {
    double farthest = 0.0;
    for (double y = -0.60; y < 0.61; y += 0.02) {
      Crossing scene(1.0);
      scene.seen.own[1] = test::standingAt({{0.05, y}, 0.0});
      scene.seen.restart = thrown ? RestartKind::kFreeBall : RestartKind::kKickOff;
      for (double time = 0.0; time < 1.5; time += 0.05) {
        const auto run = libero::volleyAt(scene.picture(), 1, time);
        if (run) farthest = std::max(farthest, std::abs(run->target.y));
      }
    }
    const libero::Pitch pitch(test::infoOf(3, "firasim"));
    CHECK(farthest > (thrown ? pitch.goal_half : 0.0));
    CHECK(farthest < pitch.goal_half + (thrown ? 1 : -1) * pitch.ball_radius);
  }
}

TEST_CASE("libero plays no volley at a ball that runs away or that it cannot reach in time", "[unit]") {
  CHECK_FALSE(libero::bestVolley(Crossing(1.0, {0.4, 0.1}).picture(), 1));
  Crossing late(1.0, {0.05, -0.5});
  late.seen.own[1] = test::standingAt({{-0.6, 0.5}, 0.0});
  CHECK_FALSE(libero::volleyAt(late.picture(), 1, 0.3));
}

}  // namespace fulbito
