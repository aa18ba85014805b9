#include "navigation/methods/hybrid/occupancy_boxes.hpp"

#include <array>
#include <vector>

#include "tests/support/catch.hpp"

using namespace fulbito;

namespace {

const OccupancyBoxes kBoxes;  // the paper's: 50 mm wide, 1.5 m long, six a side

}  // namespace

// docs/papers.md on (7) to (9): the section's length is the distance of the two points, its centre their
// midpoint.
TEST_CASE("echoes on one side: the section runs from the nearest to the farthest occupied box", "[unit]") {
  const std::vector<Vec2> left{{1.0, 0.22}, {0.8, 0.03}, {0.9, 0.12}};
  const auto section = frontSection(left, kBoxes);
  REQUIRE(section);
  CHECK(section->first == Vec2{0.8, 0.03});
  CHECK(section->second == Vec2{1.0, 0.22});
  CHECK(section->centre().x == Approx(0.9));
  CHECK(section->centre().y == Approx(0.125));
  CHECK(section->width() == Approx(distance({0.8, 0.03}, {1.0, 0.22})));
  const std::vector<Vec2> right{{1.0, -0.22}, {0.8, -0.03}, {0.9, -0.12}};
  CHECK(frontSection(right, kBoxes)->centre().y == Approx(-0.125));
}

TEST_CASE("echoes on both sides: the section runs from the farthest left to the farthest right", "[unit]") {
  const std::vector<Vec2> echoes{{0.7, 0.01}, {1.0, 0.22}, {0.6, -0.02}, {0.8, -0.13}};
  const auto section = frontSection(echoes, kBoxes);
  REQUIRE(section);
  CHECK(section->first == Vec2{1.0, 0.22});
  CHECK(section->second == Vec2{0.8, -0.13});
  // (9) as printed gives the same where the left y is positive and the right one negative.
  CHECK(section->centre().y == Approx(0.22 - (0.22 + 0.13) / 2));
}

TEST_CASE("a box keeps its nearest echo; one box makes a section without width", "[unit]") {
  const std::vector<Vec2> echoes{{1.2, 0.02}, {0.9, 0.04}, {1.1, 0.01}};
  const auto section = frontSection(echoes, kBoxes);
  REQUIRE(section);
  CHECK(section->first == Vec2{0.9, 0.04});
  CHECK(section->width() == 0.0);
}

TEST_CASE("echoes behind, beyond and beside the boxes do not count", "[unit]") {
  const std::vector<Vec2> echoes{{-0.2, 0.0}, {1.51, 0.0}, {0.5, 0.31}, {0.5, -0.31}};
  CHECK_FALSE(frontSection(echoes, kBoxes));
}
