#include "bridge/wire/seen_world.hpp"

#include <limits>

#include "tests/support/catch.hpp"

namespace fulbito::wire {
namespace {

SeenRobot robot(std::uint32_t number, double x) {
  SeenRobot seen{number, {}};
  seen.state.pose.position.x = x;
  return seen;
}

}  // namespace

TEST_CASE("a frame becomes a world in the order of ids", "[unit]") {
  Vision vision;
  vision.ball.position = {0.5, 0.25};
  vision.robots[0] = {robot(2, 0.2), robot(0, 0.1), robot(2, 0.9), robot(3, 0.3)};
  vision.robots[1] = {robot(1, -0.1)};
  const auto seen = seenWorld(vision, 3);
  REQUIRE(seen);
  CHECK(seen->ids == std::vector<RobotId>{{TeamId::kBlue, 0}, {TeamId::kBlue, 2}, {TeamId::kYellow, 1}});
  CHECK(seen->robots[1].pose.position.x == 0.2);
  CHECK(seen->ball.position == Vec2{0.5, 0.25});
  CHECK(seen->unknown == 1);
}

TEST_CASE("a frame with a value that is not finite is no world", "[unit]") {
  Vision vision;
  vision.robots[1] = {robot(1, std::numeric_limits<double>::infinity())};
  CHECK_FALSE(seenWorld(vision, 3));
  CHECK(seenWorld(vision, 1));  // it is not in this match
  vision.ball.velocity.y = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(seenWorld(vision, 1));
}

TEST_CASE("a field must be that of the rules to a centimetre", "[unit]") {
  Vision vision;
  vision.field.length = 1.505;
  vision.field.width = 1.3;
  FieldGeometry field;
  field.length = 1.5;
  field.width = 1.3;
  CHECK(checkField(vision, field, "mine"));
  vision.field.width = 1.8;
  const auto other = checkField(vision, field, "mine");
  REQUIRE_FALSE(other);
  CHECK(other.error().code == ErrorCode::kUsage);
  CHECK(other.error().message.find("the rules mine") != std::string::npos);
}

}  // namespace fulbito::wire
