#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/striker/wall_scene.hpp"

namespace fulbito {
namespace {

/// Time [s] until a single robot has a resting ball in the opponents' goal; negative for an own goal; 0 if
/// there is no goal.
double secondsToScore(Vec2 robot, Vec2 ball) {
  Placement scene;
  scene.ball = ball;
  scene.robots[0][1] = Pose2{robot, 1.0};
  Match match = test::matchFrom(test::matchOf("libero", "idle", "vsss-3v3", 10.0), scene);
  while (match.step()) {
    const PerTeam<int> score = match.referee().score;
    if (score[0] > 0) return match.seconds();
    if (score[1] > 0) return -match.seconds();
  }
  return 0.0;
}

}  // namespace

TEST_CASE("a lone libero brings a resting ball into the right goal", "[unit]") {
  int scored = 0;
  for (const Vec2 ball :
       {Vec2{0.4, 0.3}, Vec2{0.0, -0.45}, Vec2{-0.45, 0.2}, Vec2{-0.55, -0.4}, Vec2{0.55, -0.4}}) {
    const double seconds = secondsToScore({0.1, 0.1}, ball);
    CHECK(seconds >= 0.0);
    scored += seconds > 0.0 ? 1 : 0;
  }
  CHECK(scored == 5);
}

TEST_CASE("a lone libero turns with a ball from their end wall into the mouth", "[unit]") {
  // The heavier robot has to come off the wall before it turns.
  for (const auto& [model, most] : {std::pair{"vsss", 3.0}, std::pair{"firasim", 5.0}}) {
    int scenes = 0, scored = 0;
    for (const double y : {0.3, 0.35, 0.4, 0.45, 0.5}) {
      for (const Vec2 off : {Vec2{-0.04, 0.08}, Vec2{-0.05, 0.1}}) {
        for (const double turned : {-0.8, -1.57, -2.3}) {
          const Vec2 ball{0.727, y};
          const double seconds =
              test::scoresAlone(ball, {ball + off, turned}, ++scenes % 2 ? 1.0 : -1.0, model);
          scored += seconds < most ? 1 : 0;
        }
      }
    }
    // At full speed it takes the ball past the mouth in nine of ten scenes.
    CAPTURE(model);
    CHECK(scored > scenes / 2);
  }
}

TEST_CASE("libero holds against one who presses on its ball head-on", "[unit]") {
  Placement scene;
  scene.ball = {-0.007, 0.046};
  scene.robots[0][1] = Pose2{{-0.069, 0.050}, -0.02};
  scene.robots[1][0] = Pose2{{0.053, 0.050}, 3.12};
  for (const double side : {1.0, -1.0}) {
    const Placement start = test::mirrored(scene, side);
    Match match = test::matchFrom(test::matchOf("libero", "chaser", "vsss-3v3", 10.0), start);
    // The direction in which the ball leaves the two robots must be sideways or upfield.
    Vec2 moved;
    while (norm(moved) < 0.04 && match.seconds() < 2.0 && match.step()) {
      moved = match.world().balls[0].position - start.ball;
    }
    CHECK(norm(moved) >= 0.04);
    CHECK(moved.x > -0.03);
  }
}

TEST_CASE("libero strikes sooner with an opponent near that can shove, but drives round a jammed ball",
          "[unit]") {
  // How much [rad/s] the wide cone changes the turn of a robot at `own`, for an opponent at `rival` and a
  // ball in the middle.
  const auto changes = [](Vec2 own, Vec2 rival, double side, const char* robot) {
    const auto turn = [&](double wide) {
      libero::Tuning tuning;
      tuning.wide_cone = wide;
      test::WallScene scene({0.0, 0.0}, own, rival, side);
      scene.pitch = libero::Pitch(test::infoOf(3, robot), tuning);
      scene.seen.own[0].state.pose.heading = 0.0;
      const auto move = scene.move(libero::striker::strike);
      return move ? move->twist.angular : 0.0;
    };
    return std::abs(turn(1.0) - turn(libero::Tuning{}.cone));
  };
  const Vec2 behind{-0.25, -0.15}, near{-0.1, 0.25};
  for (const double side : {test::kUp, test::kDown}) {
    CHECK(changes(behind, near, side, "vsss") > 0.1);
    CHECK(changes(behind, {-0.2, 0.45}, side, "vsss") == 0.0);
    CHECK(changes(behind, near, side, "firasim") == 0.0);
    CHECK(changes({-0.055, -0.03}, {0.061, 0.0}, side, "vsss") == 0.0);
    CHECK(changes({-0.055, -0.03}, near, side, "vsss") > 0.1);
  }
}

}  // namespace fulbito
