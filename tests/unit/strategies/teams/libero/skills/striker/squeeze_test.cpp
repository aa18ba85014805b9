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

TEST_CASE("libero squeezes longer in its half than in theirs", "[unit]") {
  const Vec2 behind{-0.07, -0.02}, ahead{0.06, -0.03};  // [m] own robot and opponent, relative to the ball
  const auto squeezes = [&](double x, double side, double stuck, double jammed) {
    const Vec2 ball{x, 0.628};
    WallScene scene(ball, ball + behind, ball + ahead, side);
    scene.stuck = stuck;
    scene.memory.press.jammed = jammed;
    return scene.move(libero::striker::squeeze).has_value();
  };
  for (const double side : {kUp, kDown}) {
    CHECK(squeezes(0.2, side, 0.0, 0.0));
    CHECK_FALSE(squeezes(0.2, side, 1.0, 0.0));  // it has been there for a while
    CHECK(squeezes(-0.2, side, 5.0, 1.0));
    CHECK_FALSE(squeezes(-0.2, side, 5.0, 3.0));  // it does not move
  }
}

TEST_CASE("libero does not squeeze in large matches", "[unit]") {
  WallScene scene(kAtEndWall, kAtEndWall + Vec2{0.02, -0.06}, kAtEndWall + Vec2{0.06, 0.03}, kUp);
  CHECK(scene.move(libero::striker::squeeze));
  scene.pitch.team_size = 5;
  CHECK_FALSE(scene.move(libero::striker::squeeze));
  CHECK(scene.move(libero::striker::race));
}

TEST_CASE("where nobody can shove, libero does not squeeze", "[unit]") {
  WallScene scene(kAtEndWall, kAtEndWall + Vec2{0.02, -0.06}, kAtEndWall + Vec2{0.06, 0.03}, kUp);
  scene.pitch = libero::Pitch(test::infoOf(3, "firasim"));
  CHECK_FALSE(scene.move(libero::striker::squeeze));
  CHECK(scene.move(libero::striker::race));
}

}  // namespace fulbito
