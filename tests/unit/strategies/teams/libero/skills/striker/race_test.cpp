#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/striker/wall_scene.hpp"

namespace fulbito {
namespace {

using test::kAtCut, test::kDown, test::kUp, test::onSide, test::WallScene;

/// Time [s] until libero has moved the ball 0.25 m up the side wall out of its corner, against a robot that
/// drives straight at it; 5 if it does not.
double secondsOut(Vec2 ball, Pose2 own, Pose2 opponent, double side) {
  MatchConfig config = test::matchOf("libero", "chaser", "vsss-3v3", 300.0);
  config.rules.stuck.seconds = config.rules.stuck.area_seconds = 20.0;
  Placement start;
  start.ball = onSide(ball, side);
  start.robots[0][0] = Pose2{onSide(own.position, side), side * own.heading};
  start.robots[1][1] = Pose2{onSide(opponent.position, side), side * opponent.heading};
  Match match = test::matchFrom(config, start);
  while (match.seconds() < 5.0 && match.step()) {
    if (match.world().balls[0].position.x > ball.x + 0.25) break;
  }
  return match.seconds();
}

}  // namespace

TEST_CASE("libero races for a ball in its corner only from our goal's side, with an opponent near",
          "[unit]") {
  for (const double side : {kUp, kDown}) {
    CHECK(WallScene(kAtCut, {-0.55, 0.35}, {-0.50, 0.60}, side).move(libero::striker::race));
    CHECK_FALSE(WallScene(kAtCut, {-0.55, 0.35}, {-0.10, 0.50}, side)
                    .move(libero::striker::race));  // there is time enough
    // it would push the ball toward its own goal
    CHECK_FALSE(WallScene(kAtCut, {-0.66, 0.62}, {-0.50, 0.60}, side).move(libero::striker::race));
    CHECK_FALSE(WallScene({-0.50, 0.30}, {-0.60, 0.20}, {-0.40, 0.40}, side)
                    .move(libero::striker::race));  // there is no wall
  }
}

TEST_CASE("libero drives straight at a ball it races for", "[unit]") {
  for (const double side : {kUp, kDown}) {
    WallScene scene(kAtCut, {-0.55, 0.35}, {-0.50, 0.60}, side);
    scene.seen.own[0].state.pose.heading = math::angleOf(scene.rel());
    const auto move = scene.move(libero::striker::race);
    REQUIRE(move);
    CHECK(move->twist.linear > 0.95 * scene.pitch.speed);
    CHECK(std::abs(move->twist.angular) < 1.5);
  }
}

TEST_CASE("libero brings a ball out of its corner though another comes at the same time", "[unit]") {
  struct Start {
    Vec2 ball;
    Pose2 own, opponent;
  };
  int scenes = 0, out = 0;
  for (const Start& start : {Start{kAtCut, {{-0.35, 0.30}, 2.5}, {{-0.12, 0.52}, 3.0}},
                             Start{{-0.695, 0.595}, {{-0.40, 0.25}, 2.3}, {{-0.10, 0.50}, 3.0}}}) {
    for (const double later : {-0.03, -0.02, -0.01, 0.0, 0.01, 0.02, 0.03}) {
      for (const double side : {kUp, kDown}) {
        Pose2 own = start.own;
        own.position.x += later;
        ++scenes;
        out += secondsOut(start.ball, own, start.opponent, side) < 5.0 ? 1 : 0;
      }
    }
  }
  CAPTURE(out, scenes);
  CHECK(out >= 14);  // of 28; in the others, two equal robots press on the ball and none gives way
}

}  // namespace fulbito
