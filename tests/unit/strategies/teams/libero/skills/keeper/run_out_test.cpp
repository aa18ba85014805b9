#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {

TEST_CASE("libero's keeper meets what is carried to its near post, and goes with what is carried past it",
          "[unit]") {
  struct Carried {
    Vec2 ball, velocity;
    Pose2 carrier, keeper;
  };
  int scenes = 0, held = 0;
  for (const Carried& c :
       {Carried{{-0.594, 0.352}, {-0.41, -0.96}, {{-0.569, 0.409}, -1.98}, {{-0.705, 0.119}, math::kPi / 2}},
        Carried{{-0.595, 0.259}, {-0.43, -0.85}, {{-0.568, 0.315}, -2.04}, {{-0.705, 0.128}, math::kPi / 2}},
        Carried{{-0.602, 0.291}, {-0.39, -0.91}, {{-0.578, 0.348}, -1.97}, {{-0.705, 0.131}, math::kPi / 2}},
        Carried{{-0.624, -0.440}, {-0.16, 0.67}, {{-0.597, -0.492}, 2.04}, {{-0.708, -0.14}, -1.57}}}) {
    for (const double aside : {-0.008, -0.004, 0.0, 0.004, 0.008}) {
      Placement scene;
      scene.ball = c.ball;
      scene.ball_velocity = c.velocity;
      scene.robots[0] = {c.keeper, Pose2{{-0.25, 0.45}, 0.0}};
      scene.robots[0][0]->position.y += aside;
      scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, c.carrier};
      for (const double side : {1.0, -1.0}) {
        ++scenes;
        held += test::playedFrom(test::mirrored(scene, side), 0.8, "chaser").referee().score[1] == 0 ? 1 : 0;
      }
    }
  }
  CAPTURE(held, scenes);
  CHECK(held >= 32);  // of 40
}

}  // namespace fulbito
