#include "experiments/papers/transport/path_fit.hpp"

#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

void checkChain(const PartPath& path) {
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    CHECK(distance(endOf(path.parts()[i]).position, path.parts()[i + 1].start.position) < 1e-9);
  }
}

double wrapped(double angle) { return std::abs(math::wrapAngle(angle)); }

}  // namespace

TEST_CASE("a biarc arrives where it shall, with one tangent at its joint", "[unit]") {
  Rng random(7, test::kTestStream);
  for (int i = 0; i < 200; ++i) {
    const Pose2 from{{0.0, 0.0}, random.uniform(-1.2, 1.2)};
    const Pose2 to{{1.0, random.uniform(-0.3, 0.3)}, random.uniform(-1.2, 1.2)};
    const std::vector<Arc> arcs = biarc(from, to);
    REQUIRE(arcs.size() == 2);
    CHECK(distance(arcs[0].start.position, from.position) < 1e-12);
    CHECK(wrapped(arcs[0].start.heading - from.heading) < 1e-9);
    CHECK(distance(endOf(arcs[0]).position, arcs[1].start.position) < 1e-9);
    CHECK(wrapped(endOf(arcs[0]).heading - arcs[1].start.heading) < 1e-6);
    CHECK(distance(endOf(arcs[1]).position, to.position) < 1e-9);
    CHECK(wrapped(endOf(arcs[1]).heading - to.heading) < 1e-6);
  }
}

TEST_CASE("headings along the chord make a line", "[unit]") {
  const auto arcs = biarc({{0.0, 0.0}, 0.5}, {math::unit(0.5) * 2.0, 0.5});
  REQUIRE(arcs.size() == 1);
  CHECK(arcs[0].curvature == 0.0);
  CHECK(arcs[0].length == Approx(2.0));
}

TEST_CASE("a straight polyline becomes one line, a circle few arcs of its radius", "[unit]") {
  std::vector<Vec2> straight, circle;
  for (int i = 0; i <= 100; ++i) {
    straight.push_back(Vec2{0.3, 0.1} * (0.02 * i));
    circle.push_back(math::unit(0.05 * i) * 0.5);
  }
  const auto line = fitPath(straight);
  REQUIRE(line);
  CHECK(line->size() == 1);
  const auto arcs = fitPath(circle);
  REQUIRE(arcs);
  CHECK(arcs->size() <= 4);
  for (const Arc& arc : arcs->parts()) CHECK(1.0 / arc.curvature == Approx(0.5).epsilon(0.05));
}

TEST_CASE("any polyline is fitted within the tolerance", "[unit]") {
  Rng random(8, test::kTestStream);
  for (int i = 0; i < 30; ++i) {
    std::vector<Vec2> points{{0.0, 0.0}};
    double heading = 0.0;
    for (int k = 0; k < 12; ++k) {
      heading += random.uniform(-1.4, 1.4);
      points.push_back(points.back() + math::unit(heading) * random.uniform(0.02, 1.0));
    }
    const auto path = fitPath(points);
    REQUIRE(path);
    checkChain(*path);
    CHECK(distanceBetween(*path, points) <= 0.005);
  }
}

TEST_CASE("only vertices sharper than the limit stay corners", "[unit]") {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {2, 0.6}, {2, 2}};  // turns of 31 and 59 degrees
  const auto path = fitPath(points);
  REQUIRE(path);
  int corners = 0;
  for (std::size_t i = 0; i + 1 < path->size(); ++i) corners += wrapped(path->jumpAfter(i)) > 1e-3 ? 1 : 0;
  CHECK(corners == 1);
}

TEST_CASE("a finer tolerance takes more parts", "[unit]") {
  std::vector<Vec2> points;
  for (int i = 0; i <= 200; ++i) points.push_back({0.015 * i, 0.3 * math::sin(0.06 * i)});
  PathFit fine;
  fine.tolerance = 0.0005;
  CHECK(fitPath(points, fine)->size() > fitPath(points)->size());
  CHECK(distanceBetween(*fitPath(points, fine), points) <= 0.0005);
}

TEST_CASE("bad polylines are refused", "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(fitPath(std::vector<Vec2>{{0, 0}}));
  CHECK_FALSE(fitPath(std::vector<Vec2>{{0, 0}, {nan, 0}}));
  CHECK_FALSE(fitPath(std::vector<Vec2>{{0, 0}, {0, 0}, {1, 0}}));
  CHECK_FALSE(fitPath(std::vector<Vec2>{{0, 0}, {1, 0}}, {0.0, 0.8}));
}

}  // namespace fulbito
