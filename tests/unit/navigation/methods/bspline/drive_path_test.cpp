#include "navigation/methods/bspline/drive_path.hpp"

#include <limits>

#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"

namespace fulbito {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

DrivePath straightPath(double end_speed = 1e9) {
  CubicSpline spline;
  for (int i = 0; i <= 5; ++i) spline.add({0.2 * i, 0.0});
  SpeedLimits limits = speedLimits(test::paperRobot(1.0), 1.0, 1.0);
  limits.end_speed = end_speed;
  DrivePath path;
  path.build(spline, limits);
  return path;
}

ForecastDisc discAt(Vec2 position, Vec2 velocity = {}) {
  ForecastDisc disc;
  disc.position = position;
  disc.velocity = velocity;
  disc.radius = 0.04;
  disc.room = {5.0, 5.0};
  disc.moves = norm(velocity) > 0.0;
  return disc;
}

double firstConflict(const DrivePath& path, const ForecastDisc& disc, DrivePath::Ride ride) {
  return path.conflict(ride, {}, std::span<const ForecastDisc>(&disc, 1));
}

}  // namespace

TEST_CASE("a drive path keeps its speed up but for what brakes", "[unit]") {
  const DrivePath open = straightPath(), stop = straightPath(0.0);
  CHECK(open.length() == Approx(1.0));
  CHECK(open.speeds().front() == Approx(1.0));
  CHECK(open.speeds().back() == Approx(1.0));
  CHECK(stop.speeds().front() == Approx(1.0));
  CHECK(stop.speeds().back() == 0.0);
}

TEST_CASE("the place on a drive path moves on and tells the distance from it", "[unit]") {
  DrivePath path = straightPath();
  CHECK(path.advanceTo({0.2, 0.03}) == Approx(0.03).margin(0.002));
  CHECK(path.span() == 1);
  path.advanceTo({0.1, 0.0});
  CHECK(path.span() == 1);
  for (double x : {0.4, 0.6, 0.8, 1.0}) path.advanceTo({x, 0.0});
  CHECK(path.finished());
}

TEST_CASE("a ride meets a disc on the path when the body's front is there", "[unit]") {
  DrivePath::Ride ride;
  ride.speed = 1.0;
  ride.margin = 0.0;
  // 0.5 m less the disc's radius and half the body, at 1 m/s.
  CHECK(firstConflict(straightPath(), discAt({0.5, 0.0}), ride) == Approx(0.4225).margin(0.045));
}

TEST_CASE("a ride that stops before a disc has no conflict with it", "[unit]") {
  DrivePath::Ride ride;
  ride.speed = 1.0;
  ride.top = 0.0;
  CHECK(firstConflict(straightPath(), discAt({0.5, 0.0}), ride) == kNever);
  CHECK(firstConflict(straightPath(), discAt({0.1, 0.0}), ride) < 0.1);
}

TEST_CASE("a crossing disc is met only when both are there at the same time", "[unit]") {
  DrivePath::Ride ride;
  ride.speed = 1.0;
  CHECK(firstConflict(straightPath(), discAt({0.5, -0.5}, {0.0, 1.0}), ride) < 0.6);
  CHECK(firstConflict(straightPath(), discAt({0.5, -0.5}, {0.0, 3.0}), ride) == kNever);
}

TEST_CASE("a robot that has to turn first meets a crossing disc later", "[unit]") {
  DrivePath::Ride ride;
  const ForecastDisc crossing = discAt({0.2, -0.25}, {0.0, 1.0});
  CHECK(firstConflict(straightPath(), crossing, ride) < kNever);
  ride.hold = 0.5;
  CHECK(firstConflict(straightPath(), crossing, ride) == kNever);
}

TEST_CASE("discs at rest beside the path's end do not count, moving ones do", "[unit]") {
  DrivePath::Ride ride;
  ride.speed = 1.0;
  ride.end = 0.3;
  CHECK(firstConflict(straightPath(), discAt({0.5, 0.0}), ride) == kNever);
  CHECK(firstConflict(straightPath(), discAt({0.5, 0.0}, {-0.05, 0.0}), ride) < kNever);
}

}  // namespace fulbito
