#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/keeper/keeper_at.hpp"

namespace fulbito {
namespace {

struct Shot {
  Vec2 ball, velocity;
  double keeper;  // its y
};

int conceded(const Shot& shot, double side, const char* robot) {
  Placement scene;
  scene.ball = shot.ball;
  scene.ball_velocity = shot.velocity;
  scene.robots[0] = {test::keeperAt({-0.695, shot.keeper}, side), Pose2{{0.6, -0.5}, 0.0}};
  return test::playedFrom(test::mirrored(scene, side), 2.0, "idle", robot).referee().score[1];
}

}  // namespace

TEST_CASE("libero's keeper goes with a slanting ball that runs on along its face", "[unit]") {
  for (const Shot& shot :
       {Shot{{-0.0899, 0.5091}, {-1.605, -1.039}, 0.0428}, Shot{{-0.1979, 0.4284}, {-1.537, -1.056}, 0.0431},
        Shot{{-0.1038, 0.5223}, {-1.500, -0.996}, 0.0448}}) {
    for (const double side : {1.0, -1.0}) {
      CAPTURE(shot.keeper, side);
      CHECK(conceded(shot, side, "vsss") == 0);
    }
  }
}

TEST_CASE("libero's keeper turns out a ball that slides along its face faster than it can go", "[unit]") {
  for (const Shot& shot :
       {Shot{{0.3034, -0.5341}, {-1.615, 0.699}, -0.0279}, Shot{{0.5459, 0.5448}, {-1.875, -0.682}, 0.0231},
        Shot{{0.3405, 0.6100}, {-1.799, -0.764}, 0.0308}, Shot{{0.5714, -0.5736}, {-1.823, 0.672}, -0.0239},
        Shot{{0.2619, 0.5708}, {-1.640, -0.736}, 0.0310}, Shot{{0.4222, 0.6060}, {-1.651, -0.682}, 0.0284}}) {
    for (const double side : {1.0, -1.0}) {
      CAPTURE(shot.keeper, side);
      CHECK(conceded(shot, side, "firasim") == 0);
    }
  }
}

}  // namespace fulbito
