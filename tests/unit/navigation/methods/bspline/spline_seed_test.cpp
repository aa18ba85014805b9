#include "navigation/methods/bspline/spline_seed.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/corner_layout.hpp"

namespace fulbito {
namespace {

const FieldGeometry kField;
const RobotModel kRobot = test::paperRobot(1.0);

ForecastDisc discAt(Vec2 position, double radius, Vec2 velocity = {}) {
  ForecastDisc disc;
  disc.position = position;
  disc.velocity = velocity;
  disc.radius = radius;
  disc.room = {0.7, 0.6};
  disc.moves = norm(velocity) > 0.0;
  return disc;
}

SeedRequest across() {
  SeedRequest request;
  request.start = {-0.5, 0.0};
  request.goal = {0.5, 0.0};
  return request;
}

}  // namespace

TEST_CASE("a seed in the open is straight from start to goal", "[unit]") {
  SplineSeeder seeder;
  REQUIRE(seeder.search(across(), kRobot, kField, {}, SplineSeeder::Room::kTurning));
  CHECK(seeder.bends() == 0);
  CHECK(seeder.length() == Approx(1.0));
  for (std::size_t i = 0; i < seeder.shortest().controls(); ++i) CHECK(seeder.shortest().control(i).y == 0.0);
}

TEST_CASE("a seed keeps given directions at its ends", "[unit]") {
  SeedRequest request = across();
  request.start_direction = Vec2{0.0, 1.0};
  request.end_direction = Vec2{0.0, -1.0};
  SplineSeeder seeder;
  REQUIRE(seeder.search(request, kRobot, kField, {}, SplineSeeder::Room::kTurning));
  const CubicSpline& seed = seeder.shortest();
  const std::size_t n = seed.controls();
  CHECK(seed.control(1).x == Approx(-0.5));
  CHECK(seed.control(1).y > 0.0);
  CHECK(seed.control(n - 2).x == Approx(0.5));
  CHECK(seed.control(n - 2).y > 0.0);
}

TEST_CASE("the other side of a bend is the mirrored way", "[unit]") {
  const std::vector<ForecastDisc> discs{discAt({0.0, -0.01}, 0.04)};
  SplineSeeder seeder;
  REQUIRE(seeder.search(across(), kRobot, kField, discs, SplineSeeder::Room::kTurning));
  REQUIRE(seeder.bends() == 1);
  const std::size_t middle = seeder.shortest().controls() / 2;
  CHECK(seeder.shortest().control(middle).y > 0.0);
  CubicSpline other;
  REQUIRE(seeder.otherSide(0, 1.2, other));
  CHECK(other.control(other.controls() / 2).y < 0.0);
  CHECK_FALSE(seeder.otherSide(0, 1.0, other));
  CHECK_FALSE(seeder.otherSide(1, 2.0, other));
}

TEST_CASE("a gap narrower than the circumscribed circle is found only for a straight robot", "[unit]") {
  std::vector<ForecastDisc> discs;
  for (int i = 0; i < 7; ++i) {
    for (double side : {-1.0, 1.0})
      discs.push_back(discAt({0.0, side * (0.0975 / 2 + 0.05 + 0.09 * i)}, 0.05));
  }
  SplineSeeder seeder;
  CHECK_FALSE(seeder.search(across(), kRobot, kField, discs, SplineSeeder::Room::kTurning));
  CHECK(seeder.search(across(), kRobot, kField, discs, SplineSeeder::Room::kStraight));
  CHECK(seeder.length() < 1.05);
}

TEST_CASE("a moving disc bends the seed where it will be met, not where it is", "[unit]") {
  SeedRequest request = across();
  request.speed = 0.5;
  // At 0.5 m/s the robot is in the middle after 1 s.
  const std::vector<ForecastDisc> coming{discAt({0.0, 0.5}, 0.05, {0.0, -0.5})};
  const std::vector<ForecastDisc> going{discAt({0.0, 0.0}, 0.05, {0.0, 0.5})};
  SplineSeeder seeder;
  REQUIRE(seeder.search(request, kRobot, kField, coming, SplineSeeder::Room::kTurning));
  CHECK(seeder.bends() == 1);
  REQUIRE(seeder.search(request, kRobot, kField, going, SplineSeeder::Room::kTurning));
  CHECK(seeder.bends() == 0);
}

}  // namespace fulbito
