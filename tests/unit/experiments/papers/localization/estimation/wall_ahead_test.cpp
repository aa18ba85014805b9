#include "experiments/papers/localization/estimation/wall_ahead.hpp"

#include "fulbito/detail/echo_scene.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

using namespace fulbito;
using namespace fulbito::localization;
using namespace fulbito::test;

namespace {

const Room kRoom{3.6, 2.7};
constexpr Body kBody{0.44, 0.36};
constexpr double kCone = 0.21817;

}  // namespace

TEST_CASE("the expected range is the exact echo of a cone, all around", "[unit]") {
  EchoScene scene;
  const std::vector<Vec2> contour{{0, 0}, {kRoom.x, 0}, {kRoom.x, kRoom.y}, {0, kRoom.y}};
  scene.addRoom(contour);
  Rng random(7, kTestStream);
  for (int i = 0; i < 400; ++i) {
    Pose2 pose;
    pose.position.x = random.uniform(0.8, 2.8);
    pose.position.y = random.uniform(0.8, 1.9);
    pose.heading = math::wrapAngle(random.below(4) * math::kPi / 2 + random.uniform(-0.9, 0.9) * kCone);
    for (const Beam beam : kBeams) {
      const WallAhead wall = wallAhead(kRoom, kBody, pose, beam);
      const Vec2 axis = math::unit(pose.heading + directionOf(beam));
      const Echo echo = scene.castCone({pose.position + axis * reachOf(kBody, beam), axis, kCone, 9.0}, 0.52);
      CHECK(wall.distance == Approx(echo.distance).epsilon(1e-9));
      CHECK(std::abs(wall.incidence) <= 0.9 * kCone + 1e-9);
    }
  }
}

TEST_CASE("the derivatives of the expected range are those of its differences", "[unit]") {
  constexpr double kStep = 1e-6;
  Rng random(8, kTestStream);
  for (int i = 0; i < 100; ++i) {
    const Pose2 pose{{random.uniform(0.8, 2.8), 1.2}, random.uniform(-3.0, 3.0)};
    for (const Beam beam : kBeams) {
      const WallAhead wall = wallAhead(kRoom, kBody, pose, beam);
      if (std::abs(wall.incidence) > 0.7) continue;  // the nearest wall changes at 45 degrees
      Pose2 turned = pose, moved = pose;
      turned.heading += kStep;
      (wall.across_x ? moved.position.x : moved.position.y) += kStep;
      const auto change = [&](const Pose2& other) {
        return (wallAhead(kRoom, kBody, other, beam).distance - wall.distance) / kStep;
      };
      CHECK(change(turned) == Approx(wall.by_heading).margin(1e-5));
      CHECK(change(moved) == Approx(-wall.sign).margin(1e-5));
    }
  }
}
