#include "navigation/obstacles/arc_sweep.hpp"

#include <algorithm>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"

namespace fulbito {
namespace {

/// A robot at the origin facing along x. Walls are far away unless the test makes the field smaller.
struct Floor {
  FieldGeometry field;
  RobotModel robot;
  std::vector<DiscObstacle> discs;
  ArcSweep sweep;

  explicit Floor(std::vector<DiscObstacle> obstacles = {}, double size = 50.0) : discs(std::move(obstacles)) {
    field.length = field.width = size;
  }
  double freeTime(const RampedArc& arc) {
    NavigationScene scene;
    scene.field = &field;
    scene.robot = &robot;
    scene.obstacles = discs;
    sweep.look(scene, 0.0, 3.0);
    return sweep.freeTime(arc);
  }
  double steady(double v, double w) { return freeTime({{}, 0.0, {v, w}}); }
};

}  // namespace

TEST_CASE("an arc's pose is that of the circle it follows", "[unit]") {
  const Pose2 quarter = poseOnArc({math::kPi / 2, math::kPi / 2}, 1.0);  // radius 1
  CHECK(quarter.position.x == Approx(1.0));
  CHECK(quarter.position.y == Approx(1.0));
  CHECK(quarter.heading == Approx(math::kPi / 2));
  const Pose2 straight = poseOnArc({2.0, 1e-9}, 0.5);
  CHECK(straight.position.x == Approx(1.0));
  CHECK(straight.position.y == Approx(0.0).margin(1e-8));
}

TEST_CASE("a ramped arc goes on where its ramp ends", "[unit]") {
  const RampedArc arc{{math::kPi / 2, math::kPi / 2}, 1.0, {0.5, 0.0}};
  CHECK(arc.poseAt(1.0).position.x == Approx(1.0));
  const Pose2 then = arc.poseAt(3.0);
  CHECK(then.position.x == Approx(1.0));
  CHECK(then.position.y == Approx(2.0));
  CHECK(arc.lengthAt(3.0) == Approx(math::kPi / 2 + 1.0));
}

TEST_CASE("straight at a disc the free time is the gap over the speed", "[unit]") {
  Floor floor({{{0.5, 0.0}, 0.03, {}}});
  const double gap = 0.5 - 0.03 - floor.robot.circumradius();
  CHECK(floor.steady(0.8, 0.0) == Approx(gap / 0.8));
  CHECK(floor.steady(0.2, 0.0) == 1.0);  // not within the horizon
}

TEST_CASE("a disc that comes closer is met where it will be", "[unit]") {
  Floor floor({{{0.9, 0.0}, 0.03, {-0.6, 0.0}}});
  const double gap = 0.9 - 0.03 - floor.robot.circumradius();
  CHECK(floor.steady(0.5, 0.0) == Approx(gap / 1.1));
  floor.discs[0].velocity = {0.6, 0.0};
  CHECK(floor.steady(0.5, 0.0) == 1.0);
}

TEST_CASE("a wall is met by the circumscribed circle", "[unit]") {
  Floor floor({}, 1.0);
  CHECK(floor.steady(1.0, 0.0) == Approx(0.5 - floor.robot.circumradius()));
}

TEST_CASE("from a touch, driving on is not free but driving away is", "[unit]") {
  Floor floor({{{0.06, 0.0}, 0.03, {}}});
  CHECK(floor.steady(0.5, 0.0) < 0.001);
  floor.discs[0].position = {-0.06, 0.0};
  CHECK(floor.steady(0.5, 0.0) == 1.0);
}

TEST_CASE("free time on random arcs agrees with a finely stepped drive", "[unit]") {
  Rng rng(5, test::kTestStream);
  int met = 0;
  for (int round = 0; round < 300; ++round) {
    Floor floor({}, 2.0);
    while (floor.discs.size() < 4) {
      const Vec2 at{rng.uniform(-0.8, 0.8), rng.uniform(-0.8, 0.8)};
      if (norm(at) > 0.15) {
        floor.discs.push_back({at, 0.0335, {rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)}});
      }
    }
    const RampedArc arc{{rng.uniform(0.0, 1.5), rng.uniform(-3.0, 3.0)},
                        0.1,
                        {rng.uniform(0.0, 1.5), rng.uniform(-3.0, 3.0)}};
    const double swept = floor.freeTime(arc), radius = floor.robot.circumradius();
    const auto roomAt = [&](double t) {
      const Vec2 p = arc.poseAt(t).position;
      double room = wallClearance(floor.field, p) - radius;
      for (const DiscObstacle& o : floor.discs) {
        room = std::min(room, distance(p, o.position + o.velocity * t) - o.radius - radius);
      }
      return room;
    };
    // A chord of 50 ms is at most v omega t^2 / 8 = 1.4 mm away from its arc, which limits the accuracy.
    double least = 1e9;
    for (int k = 0; k <= 2000; ++k) least = std::min(least, roomAt(swept * k / 2000.0));
    CHECK(least > -0.0015);
    if (swept >= 1.0) continue;
    ++met;
    CHECK(roomAt(swept) < 0.0015);
  }
  CHECK(met > 50);
}

}  // namespace fulbito
