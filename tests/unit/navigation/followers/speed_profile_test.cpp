#include "navigation/followers/speed_profile.hpp"

#include <cmath>
#include <vector>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"

namespace fulbito {
namespace {

std::vector<Vec2> line(double length, int points) {
  std::vector<Vec2> path;
  for (int i = 0; i <= points; ++i) path.push_back({length * i / points, 0.0});
  return path;
}

}  // namespace

TEST_CASE("a straight path from rest takes the time of a ramp and a cruise", "[unit]") {
  const auto path = line(1.65, 600);
  std::vector<double> curvature(path.size(), 0.0), speeds(path.size());
  for (double top : {0.6, 1.0, 2.6}) {
    const double time = timePath(path, curvature, speedLimits(test::paperRobot(top), 1.0, 1.0), speeds);
    CHECK(time == Approx(1.65 / top + top / 10.0).epsilon(0.01));
  }
}

TEST_CASE("speeds brake ahead of a stop with the wheel acceleration", "[unit]") {
  const auto path = line(1.0, 400);
  std::vector<double> curvature(path.size(), 0.0), speeds(path.size());
  SpeedLimits limits = speedLimits(test::paperRobot(2.6), 0.6, 1.0);
  limits.start_speed = 2.6;
  limits.end_speed = 0.0;
  timePath(path, curvature, limits, speeds);
  CHECK(speeds.back() == 0.0);
  CHECK(speeds[200] == Approx(std::sqrt(2.0 * 3.0 * 0.5)).epsilon(1e-6));
}

TEST_CASE("speeds in a bend keep within grip and wheel speed", "[unit]") {
  std::vector<Vec2> path;
  for (int i = 0; i <= 100; ++i) path.push_back(math::unit(0.03 * i) * 0.25);
  std::vector<double> curvature(path.size()), speeds(path.size());
  pathCurvature(path, curvature);
  CHECK(curvature[50] == Approx(4.0).epsilon(1e-3));
  SpeedLimits limits = speedLimits(test::paperRobot(2.6), 1.0, 0.5);
  limits.start_speed = 2.6;
  timePath(path, curvature, limits, speeds);
  CHECK(speeds[50] == Approx(std::sqrt(3.0 * 0.25)).epsilon(1e-3));
  limits.max_speed = 0.5;
  timePath(path, curvature, limits, speeds);
  CHECK(speeds[50] == Approx(0.5 / (1.0 + 0.034 * 4.0)).epsilon(1e-3));
}

}  // namespace fulbito
