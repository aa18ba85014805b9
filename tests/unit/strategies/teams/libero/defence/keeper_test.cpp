#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/strategies/teams/libero/scenes.hpp"

namespace fulbito {
namespace {

/// The pose of a keeper that faces left in the scene and in its mirror image. So its front and its back are
/// exchanged between the two.
Pose2 keeperAt(Vec2 place, double side) { return {place, side * math::kPi / 2}; }

}  // namespace

TEST_CASE("libero's keeper clears a ball that lies beside its goal, though two wait for it", "[unit]") {
  Placement scene;
  scene.ball = {-0.688, 0.225};
  scene.robots[0] = {Pose2{{-0.70, 0.17}, math::kPi / 2}, Pose2{{0.2, 0.3}, 0.0}, Pose2{{0.2, -0.3}, 0.0}};
  scene.robots[1] = {Pose2{{-0.50, 0.30}, 0.0}, Pose2{{-0.50, 0.42}, 0.0}};
  const Match match = test::playedFrom(scene, 1.0);
  CHECK(distance(match.world().balls[0].position, scene.ball) > 0.15);
  CHECK(match.referee().score[1] == 0);
}

TEST_CASE("libero's keeper clears a ball that creeps off it, though two wait for it", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.645, -0.079};
    scene.ball_velocity = {0.11, -0.07};
    scene.robots[0] = {keeperAt({-0.745, -0.077}, side), Pose2{{-0.25, -0.45}, 0.0},
                       Pose2{{-0.25, 0.3}, 0.0}};
    scene.robots[1] = {Pose2{{-0.445, -0.25}, 0.0}, Pose2{{-0.369, 0.085}, 0.0}};
    scene = test::mirrored(scene, side);
    const Match match = test::playedFrom(scene, 1.0);
    CHECK(distance(match.world().balls[0].position, scene.ball) > 0.2);
    CHECK(match.referee().score[1] == 0);
  }
}

TEST_CASE("libero's keeper does not push a ball in that lies behind it in the mouth", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.745, -0.006};
    scene.robots[0] = {keeperAt({-0.712, 0.052}, side), Pose2{{-0.25, -0.45}, 0.0}};
    const Match match = test::playedFrom(test::mirrored(scene, side), 1.5);
    CHECK(match.referee().score[1] == 0);
  }
}

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
      scene.robots[0] = {keeperAt({-0.695, shot.keeper}, side), Pose2{{0.6, -0.5}, 0.0}};
      const Match match = test::playedFrom(test::mirrored(scene, side), 2.0);
      CHECK(match.referee().score[1] == 0);
    }
  }
}

TEST_CASE("libero's keeper goes out to a ball that creeps along its end wall", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    for (const char* opponent : {"chaser", "classic"}) {
      CAPTURE(side, opponent);
      Placement scene;
      scene.ball = {-0.728, -0.446};
      scene.ball_velocity = {0.0, 0.21};
      scene.robots[0] = {keeperAt({-0.708, -0.173}, side), Pose2{{-0.46, -0.245}, 0.0}};
      scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.70, -0.56}, -1.15}};
      const Match match = test::playedFrom(test::mirrored(scene, side), 0.5, opponent);
      // The keeper has met the ball outside its post, and the opponent has not passed.
      CHECK(side * match.world().robots[0].pose.position.y < -0.30);
      CHECK(side * match.world().balls[0].position.y < -0.35);
    }
  }
}

TEST_CASE("libero's keeper stays at its post before a ball that is brought fast along the end wall",
          "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.728, -0.45};
    scene.ball_velocity = {0.0, 2.0};
    scene.robots[0] = {keeperAt({-0.708, -0.15}, side), Pose2{{-0.2, 0.3}, 0.0}};
    const Match match = test::playedFrom(test::mirrored(scene, side), 0.10);
    CHECK(side * match.world().robots[0].pose.position.y > -0.19);
    CHECK(test::playedFrom(test::mirrored(scene, side), 2.0).referee().score[1] == 0);
  }
}

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

TEST_CASE("libero's keeper that was pushed into the goal pushes the ball before it out at once", "[unit]") {
  for (const double side : {1.0, -1.0}) {
    CAPTURE(side);
    Placement scene;
    scene.ball = {-0.715, 0.02};
    scene.robots[0] = {keeperAt({-0.778, 0.02}, side), Pose2{{-0.25, 0.45}, 0.0}};
    scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.35, 0.2}, 0.0}};
    const Match match = test::playedFrom(test::mirrored(scene, side), 1.0);
    CHECK(match.world().balls[0].position.x > -0.6);
    CHECK(match.referee().score[1] == 0);
  }
}

TEST_CASE("libero's keeper holds a ball out that is pressed past the post beside it", "[unit]") {
  Placement scene;
  scene.ball = {-0.728, -0.205};
  scene.robots[0] = {Pose2{{-0.699, -0.149}, -1.70}, Pose2{{-0.25, -0.45}, 0.0}};
  scene.robots[1] = {Pose2{{0.6, 0.0}, 0.0}, Pose2{{-0.702, -0.259}, 1.91}};
  test::checkHolds(scene, 1.0, "chaser");
}

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
