#include "navigation/obstacles/forecast.hpp"

#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

ForecastDisc foreseen(const DiscObstacle& obstacle) {
  const FieldGeometry field;
  const RobotModel robot;
  NavigationScene scene;
  scene.field = &field;
  scene.robot = &robot;
  scene.obstacles = std::span<const DiscObstacle>(&obstacle, 1);
  std::vector<ForecastDisc> out;
  CHECK(forecast(scene, out) == (norm(obstacle.velocity) > 0.03));
  return out.front();
}

}  // namespace

TEST_CASE("a disc is foreseen straight on", "[unit]") {
  const ForecastDisc disc = foreseen({{0.1, -0.2}, 0.05, {0.3, 0.4}});
  CHECK(distance(disc.at(0.5), {0.25, 0.0}) < 1e-12);
}

TEST_CASE("a disc is foreseen to come back mirrored from a wall", "[unit]") {
  // The disc's surface reaches x = 0.75 after 0.25 s, then the disc moves back for 0.25 s.
  const ForecastDisc disc = foreseen({{0.45, 0.0}, 0.05, {1.0, 0.2}});
  CHECK(distance(disc.at(0.25), {0.70, 0.05}) < 1e-12);
  CHECK(distance(disc.at(0.50), {0.45, 0.10}) < 1e-12);
}

TEST_CASE("a disc that hardly moves is taken to stand", "[unit]") {
  const ForecastDisc disc = foreseen({{0.1, 0.1}, 0.05, {0.02, 0.0}});
  CHECK(disc.at(5.0) == Vec2{0.1, 0.1});
}

}  // namespace fulbito
