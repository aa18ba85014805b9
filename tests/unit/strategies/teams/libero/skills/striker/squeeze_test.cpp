#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/striker/wall_scene.hpp"

namespace fulbito {
namespace {

using test::kAtEndWall, test::kDown, test::kUp, test::WallScene;

}  // namespace

TEST_CASE("libero squeezes a ball between the ball's own direction and the wall's", "[unit]") {
  const Vec2 off{0.02, -0.06};  // [m] position of the robot relative to the ball
  for (const double side : {kUp, kDown}) {
    const WallScene scene(kAtEndWall, kAtEndWall + off, kAtEndWall + Vec2{0.06, 0.03}, side);
    CHECK(scene.move(libero::striker::squeeze));
    const auto turn = [&](double heading) {
      WallScene turned = scene;
      turned.seen.own[0].state.pose.heading = side * heading;
      const auto move = turned.move(libero::striker::squeeze);
      REQUIRE(move);
      CHECK(move->twist.linear > 0.8 * scene.pitch.speed);
      return side * move->twist.angular;
    };
    CHECK(turn(math::angleOf(-off)) < 0.0);  // a push straight at the ball would only hold it
    // parallel to the wall, the ball would slip through behind the robot
    CHECK(turn(math::kPi / 2) > 0.0);
    const WallScene early(kAtEndWall, kAtEndWall + off, kAtEndWall + Vec2{0.25, 0.05}, side);
    CHECK_FALSE(early.move(libero::striker::squeeze));
    const WallScene far(kAtEndWall, kAtEndWall + 2.5 * off, kAtEndWall + Vec2{0.06, 0.03}, side);
    CHECK_FALSE(far.move(libero::striker::squeeze));
  }
}

TEST_CASE("libero squeezes a ball that is pressed at the wall of its half out of there", "[unit]") {
  Placement scene;
  scene.ball = {-0.62, 0.628};
  scene.robots[0][1] = Pose2{{-0.67, 0.57}, 0.66};
  scene.robots[1][1] = Pose2{{-0.56, 0.607}, -1.9};
  for (const double side : {1.0, -1.0}) {
    const Match match = test::playedFrom(test::mirrored(scene, side), 4.0, "chaser");
    CHECK(match.world().balls[0].position.x > scene.ball.x + 0.15);
    CHECK(match.referee().score[1] == 0);
  }
}

TEST_CASE("where nobody can shove, libero holds a ball at a wall of their half for the free ball", "[unit]") {
  const auto twist = [](const char* robot, double x, double side, double stuck = 0.0, double rule = 10.0) {
    const Vec2 ball{x, 0.628}, off{-0.055, -0.024};
    WallScene scene(ball, ball + off, ball + Vec2{0.045, -0.06}, side);
    MatchInfo info = test::infoOf(3, robot);
    info.rules.stuck.seconds = rule;
    scene.pitch = libero::Pitch(info);
    scene.seen.own[0].state.pose.heading = side * math::angleOf(-off);
    scene.stuck = stuck;
    const auto move = scene.move(libero::striker::squeeze);
    REQUIRE(move);
    return Twist{move->twist.linear, side * move->twist.angular};
  };
  for (const double side : {kUp, kDown}) {
    const Twist holds = twist("firasim", 0.3, side);
    CHECK(std::abs(holds.angular) < 1e-6);                        // straight at the ball
    CHECK(std::abs(holds.linear) < 0.05);                         // a push would creep
    const Twist late = twist("firasim", 0.3, side, 15.0);         // nobody gives a free ball
    const Twist never = twist("firasim", 0.3, side, 0.0, 600.0);  // nor will anybody
    for (const Twist& pushes : {twist("firasim", -0.3, side), twist("vsss", 0.3, side), late, never}) {
      CHECK(pushes.angular < -0.5);  // along the wall
      CHECK(pushes.linear > 0.2);
    }
  }
}

TEST_CASE("where nobody can shove, libero holds a ball against an opponent that pushes", "[unit]") {
  MatchConfig config = test::matchOf("libero", "chaser", "vsss-3v3", 20.0);
  config.robot = *loadRobot("firasim");
  Placement scene;
  scene.ball = {0.3, 0.628};
  scene.robots[0][1] = Pose2{{0.245, 0.604}, 0.41};
  scene.robots[1][1] = Pose2{{0.355, 0.604}, 2.73};
  for (const double side : {kUp, kDown}) {
    Match match = test::matchFrom(config, test::mirrored(scene, side));
    while (match.seconds() < config.rules.stuck.seconds - 1.0 && match.step()) {
    }
    CHECK(distance(match.world().balls[0].position, test::onSide(scene.ball, side)) <
          config.rules.stuck.radius);
  }
}

}  // namespace fulbito
