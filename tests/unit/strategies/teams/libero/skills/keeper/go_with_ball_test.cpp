#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"
#include "tests/unit/strategies/teams/libero/skills/keeper/keeper_at.hpp"

namespace fulbito {

TEST_CASE("libero's keeper goes with a slanting ball that runs on along its face", "[unit]") {
  struct Shot {
    Vec2 ball, velocity;
    double keeper;
  };
  for (const Shot& shot :
       {Shot{{-0.0899, 0.5091}, {-1.605, -1.039}, 0.0428}, Shot{{-0.1979, 0.4284}, {-1.537, -1.056}, 0.0431},
        Shot{{-0.1038, 0.5223}, {-1.500, -0.996}, 0.0448}}) {
    for (const double side : {1.0, -1.0}) {
      CAPTURE(shot.keeper, side);
      Placement scene;
      scene.ball = shot.ball;
      scene.ball_velocity = shot.velocity;
      scene.robots[0] = {test::keeperAt({-0.695, shot.keeper}, side), Pose2{{0.6, -0.5}, 0.0}};
      const Match match = test::playedFrom(test::mirrored(scene, side), 2.0);
      CHECK(match.referee().score[1] == 0);
    }
  }
}

}  // namespace fulbito
