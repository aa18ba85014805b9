#include "fulbito/detail/math.hpp"
#include "strategies/teams/libero/playbook/skills.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/keeper/keeper_at.hpp"

namespace fulbito {

TEST_CASE("libero's keeper stays at its post before a ball that is brought fast along the end wall",
          "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.728, -0.45};
    scene.ball_velocity = {0.0, 2.0};
    scene.robots[0] = {test::keeperAt({-0.708, -0.15}, side), Pose2{{-0.2, 0.3}, 0.0}};
    const Match match = test::playedFrom(test::mirrored(scene, side), 0.10);
    CHECK(side * match.world().robots[0].pose.position.y > -0.19);
    CHECK(test::playedFrom(test::mirrored(scene, side), 2.0).referee().score[1] == 0);
  }
}

TEST_CASE("libero's keeper holds a ball out that is pressed past the post beside it", "[unit]") {
  Placement scene;
  scene.ball = {-0.728, -0.205};
  scene.robots[0] = {Pose2{{-0.699, -0.149}, -1.70}, Pose2{{-0.25, -0.45}, 0.0}};
  scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.702, -0.259}, 1.91}};
  test::checkHolds(scene, 1.0, "chaser");
}

TEST_CASE("libero's keeper outside its post does not go back before a ball at the end wall", "[unit]") {
  const libero::Pitch pitch(test::infoOf(3));
  const auto place = [&](double side, double x) {
    Observation seen;
    seen.team_size = 3;
    seen.own[0] = test::standingAt({{x, side * 0.3}, side * math::kPi / 2});
    seen.ball.position = {-0.728, side * 0.48};
    libero::BallForecast forecast;
    forecast.take(seen.ball, {});
    libero::Memory memory;
    const auto move = libero::keeper::guardPost({seen, pitch, forecast}, 0, memory);
    return move && move->place ? side * move->place->y : 0.0;
  };
  for (const double side : {1.0, -1.0}) {
    CHECK(place(side, -0.70) == Approx(0.3));
    CHECK(place(side, -0.60) < pitch.goal_half);  // off the wall a ball would pass behind it
  }
}

}  // namespace fulbito
