#include "experiments/papers/localization/cleaning_route.hpp"

#include <algorithm>
#include <cmath>

#include "experiments/papers/localization/route_driver.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;
using namespace fulbito::localization;

namespace {

constexpr double kMargin = 0.4;

/// Whether the route passes a place within half of `spacing`.
bool covers(const CleaningRoute& route, Vec2 place, double spacing) {
  for (std::size_t i = 1; i < route.points.size(); ++i) {
    if (distanceFromPart(place, route.points[i - 1], route.points[i]) <= spacing / 2 + 1e-9) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("a route goes to the wall ahead, round all walls, to the origin, over the floor and back",
          "[unit]") {
  for (const Room room : {Room{4.0, 3.0}, Room{2.6, 3.7}}) {
    for (const double heading : {-math::kPi / 2, -math::kPi}) {
      const Pose2 start{{1.1, 1.3}, heading};
      const CleaningRoute route = cleaningRoute(room, start, kMargin, 0.36);
      CHECK(route.points.front() == start.position);
      const Vec2 wall = heading == -math::kPi ? Vec2{kMargin, 1.3} : Vec2{1.1, kMargin};
      CHECK(route.points[route.round_begins] == wall);
      CHECK(route.points[route.round_ends] == Vec2{kMargin, kMargin});
      CHECK(route.points.back() == Vec2{kMargin, kMargin});
      for (const Vec2 corner : {Vec2{room.x - kMargin, kMargin}, Vec2{room.x - kMargin, room.y - kMargin},
                                Vec2{kMargin, room.y - kMargin}}) {
        const auto begin = route.points.begin();
        const auto end = begin + static_cast<std::ptrdiff_t>(route.round_ends);
        CHECK(std::find(begin, end, corner) != end);
      }
      // Parts along the walls are parallel to an axis, so that echoes of the other walls are best.
      for (std::size_t i = 1; i < route.points.size(); ++i) {
        const Vec2 part = route.points[i] - route.points[i - 1];
        CHECK(std::min(std::abs(part.x), std::abs(part.y)) < 1e-9);
      }
      for (double x = kMargin; x <= room.x - kMargin; x += 0.07) {
        for (double y = kMargin; y <= room.y - kMargin; y += 0.07) CHECK(covers(route, {x, y}, 0.36));
      }
    }
  }
}

TEST_CASE("the distance from a part ends at its ends", "[unit]") {
  CHECK(distanceFromPart({1.0, 0.3}, {0.0, 0.0}, {2.0, 0.0}) == Approx(0.3));
  CHECK(distanceFromPart({2.3, 0.4}, {0.0, 0.0}, {2.0, 0.0}) == Approx(0.5));
  CHECK(distanceFromPart({0.3, 0.4}, {0.0, 0.0}, {0.0, 0.0}) == Approx(0.5));
}

TEST_CASE("a driver follows its route through jumps of its pose", "[unit]") {
  RouteDriver driver({{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}}, {});
  Pose2 pose{{0.0, 0.0}, 0.6};
  double worst = 0.0;
  int ticks = 0;
  for (; !driver.finished() && ticks < 2000; ++ticks) {
    const Twist twist = driver.drive(pose);
    pose.position += math::unit(pose.heading) * (twist.linear * 0.05);
    pose.heading = math::wrapAngle(pose.heading + twist.angular * 0.05);
    if (ticks % 100 == 99) pose.position.y += 0.025;  // a correction of the pose
    const std::size_t part = std::min<std::size_t>(driver.part(), 1);
    worst =
        std::max(worst, distanceFromPart(pose.position, driver.points()[part], driver.points()[part + 1]));
  }
  CHECK(driver.finished());
  CHECK(worst < 0.035);
  CHECK(distance(pose.position, {3.0, 2.0}) < 0.01);
}
