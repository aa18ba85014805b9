#include <cmath>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero's keeper keeps its line before a fast ball that it could be first at", "[unit]") {
  struct Slip {
    Vec2 ball, velocity;
    Pose2 keeper;
  };
  // Balls that come out of a duel in the midfield.
  for (const Slip& slip : {Slip{{-0.336, 0.083}, {-0.92, 0.25}, {{-0.702, 0.114}, 1.62}},
                           Slip{{-0.385, 0.116}, {-1.14, 0.32}, {{-0.700, 0.092}, -1.51}}}) {
    CAPTURE(slip.ball.x);
    Placement scene;
    scene.ball = slip.ball;
    scene.ball_velocity = slip.velocity;
    scene.robots[0] = {slip.keeper, Pose2{{-0.12, -0.05}, 0.0}};
    scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.276, 0.047}, math::kPi}};
    test::checkHolds(scene, 1.0);
  }
}

// As after a clearance that an opponent stopped: the keeper has passed the ball, and must go home.
TEST_CASE("libero's keeper drives round a ball on its way home, not through it", "[unit]") {
  for (const Vec2 ball : {Vec2{-0.62, 0.0}, Vec2{-0.62, 0.03}, Vec2{-0.66, -0.02}, Vec2{-0.6, 0.06}}) {
    CAPTURE(ball.x, ball.y);
    Placement scene;
    scene.ball = ball;
    scene.robots[0] = {Pose2{{-0.48, 0.01}, math::kPi / 2}, Pose2{{0.1, -0.1}, 0.0}};
    scene.robots[1] = {Pose2{{0.7, 0.0}, math::kPi / 2}, Pose2{{-0.59, 0.12}, math::kPi / 2}};
    test::checkHolds(scene, 1.5);
  }
}

// One that runs out at the taker opens both corners, and takers here shoot at the corners.
TEST_CASE("libero's keeper begins their penalty side on in the middle of its goal, and stays there",
          "[unit]") {
  for (const char* robot : {"vsss", "firasim"}) {
    CAPTURE(robot);
    MatchConfig config = test::matchOf("libero", "idle", "vsss-3v3", 10.0);
    config.robot = *loadRobot(robot);
    config.placement_error = {0.0, 0.0};
    config.opening =
        makeCall(refereeSetup(config), {}, {RestartKind::kPenalty, TeamId::kYellow, {}, nullptr});
    auto match = Match::create(config);
    REQUIRE(match);
    REQUIRE(match->step());
    CHECK(match->world().balls.front().position.x == Approx(-0.375).margin(0.01));
    while (match->seconds() < 2.0 && match->step()) {
      const Pose2& keeper = match->world().robots[0].pose;
      CHECK(keeper.position.x < -0.69);
      // Once a mate has struck the ball, the keeper goes along with it.
      const bool lies = distance(match->world().balls.front().position, {-0.375, 0.0}) < 0.01;
      CHECK(std::abs(keeper.position.y) < (lies ? 0.01 : 0.2));
      CHECK(std::abs(std::cos(keeper.heading)) < 0.1);
    }
  }
}

}  // namespace fulbito
