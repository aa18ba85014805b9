#include "navigation/methods/hybrid/avoidance_table.hpp"

#include <array>

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

constexpr double kDegree = math::kPi / 180.0;
const AvoidanceRanges kRanges;  // the paper's robot: 0.3 and 0.6 m

std::array<double, kTableSonars> only(std::size_t sonar, double range) {
  std::array<double, kTableSonars> readings;
  readings.fill(1.5);
  readings[sonar] = range;
  return readings;
}

double degrees(std::size_t sonar, double range, double goal = 0.0) {
  const auto direction = avoidanceDirection(only(sonar, range), goal * kDegree, kRanges);
  REQUIRE(direction);
  return *direction / kDegree;
}

}  // namespace

TEST_CASE("at I1 the command is the table's angle, on both sides alike", "[unit]") {
  const std::array<double, 8> table{-10.0, -30.0, -50.0, -80.0, 80.0, 50.0, 30.0, 10.0};
  for (std::size_t sonar = 0; sonar < table.size(); ++sonar)
    CHECK(degrees(sonar, kRanges.near) == Approx(table[sonar]));
}

TEST_CASE("nearer than I1 the command turns on by up to 90 degrees, away from the obstacle", "[unit]") {
  CHECK(degrees(2, 0.15) == Approx(-50.0 - 45.0));
  CHECK(degrees(5, 0.15) == Approx(50.0 + 45.0));
  CHECK(degrees(1, 0.0) == Approx(-30.0 - 90.0));
  // As printed, alpha = (I2 - S)(90 deg / I1) would be 90 degrees at I1 already and 180 at contact.
  CHECK(degrees(2, 0.2999) == Approx(-50.0).margin(0.1));
}

TEST_CASE("between I1 and I2 the command is half way between the table's angle and the goal", "[unit]") {
  CHECK(degrees(2, 0.45, 30.0) == Approx((-50.0 + 30.0) / 2));
  CHECK(degrees(5, 0.45, 30.0) == Approx((50.0 + 30.0) / 2));
  // Opposite directions cancel: the table's alone is left.
  CHECK(degrees(3, 0.45, 100.0) == Approx(-80.0));
}

TEST_CASE("beyond I2 the table is silent", "[unit]") {
  CHECK(avoidanceDirection(only(3, 0.6), 0.0, kRanges));
  CHECK_FALSE(avoidanceDirection(only(3, 0.6001), 0.0, kRanges));
}

TEST_CASE("as printed the outermost sonars turn nothing, and the angle jumps by 90 degrees at I1", "[unit]") {
  AvoidanceRanges printed;
  printed.as_printed = true;
  const auto degrees_of = [&](std::size_t sonar, double range) {
    return *avoidanceDirection(only(sonar, range), 0.0, printed) / kDegree;
  };
  CHECK(degrees_of(0, 0.5) == Approx(0.0).margin(1e-9));
  CHECK(degrees_of(2, printed.near) == Approx(-50.0 - 90.0));
  CHECK(degrees_of(2, printed.near + 1e-6) == Approx(-25.0));
}
