#include "bridge/abi/team_values.hpp"

#include <cstring>
#include <limits>

#include "fulbito/team.hpp"
#include "navigation/library/plugin_values.hpp"
#include "tests/support/catch.hpp"

namespace fulbito {
namespace {

bool same(Vec2 a, team::Vec2 b) { return a.x == b.x && a.y == b.y; }
bool same(const Pose2& a, const team::Pose& b) {
  return same(a.position, b.position) && a.heading == b.heading;
}
bool same(WheelSpeeds a, team::Wheels b) { return a.left == b.left && a.right == b.right; }

/// What the simulator gets of a team's commands.
TeamCommand throughAbi(const team::Commands& commands) {
  CommandRoom room;
  fulbito_team_command abi = room.open(true);
  team::detail::give(commands, kMaxTeamSize, abi);
  room.close(abi);
  TeamCommand got;
  fromAbi(abi, kMaxTeamSize, got);
  return got;
}

}  // namespace

TEST_CASE("an observation written over an older one keeps nothing of it", "[unit]") {
  Observation seen;
  for (std::size_t i = 0; i < 3; ++i) {
    seen.own[i] = seen.opponents[i] = {true, {{{1.0, 2.0}, 3.0}, {4.0, 5.0}, 6.0, {7.0, 8.0}}};
    seen.sent[i] = {9.0, 10.0};
  }
  fulbito_observation abi{};
  toAbi(seen, abi);
  seen.own[0].present = seen.opponents[2].present = false;
  seen.wants_drawings = true;
  toAbi(seen, abi);
  const auto fresh = abiOf<fulbito_observation>(seen);
  CHECK(std::memcmp(&abi, &fresh, sizeof abi) == 0);
  CHECK(abi.own[0].position.x == 0.0);
  CHECK(abi.own[1].present == 1);
}

TEST_CASE("commands come back whole", "[unit]") {
  team::Commands commands;
  commands.wheels(0, 1.5, -2.5);
  commands.twist(1, 0.25, 3.5);
  commands.roles = {1, 2, 255};
  commands.line({0.1, 0.2}, {0.3, 0.4});
  commands.circle({0.5, 0.6}, 0.7);
  commands.text({0.8, 0.9}, "here");
  const TeamCommand got = throughAbi(commands);
  CHECK(got.robots[0].kind == RobotCommand::Kind::kWheels);
  CHECK(same(got.robots[0].wheels, {1.5, -2.5}));
  CHECK_FALSE(got.robots[0].go_to.heading);
  CHECK(got.robots[1].kind == RobotCommand::Kind::kTwist);
  CHECK(got.robots[1].twist.linear == 0.25);
  CHECK(got.robots[1].twist.angular == 3.5);
  CHECK(got.roles[0] == 1);
  CHECK(got.roles[2] == 255);
  REQUIRE(got.drawings.size() == 3);
  CHECK(got.drawings[0].kind == DebugDrawing::Kind::kLine);
  CHECK(same(got.drawings[0].to, {0.3, 0.4}));
  CHECK(got.drawings[1].kind == DebugDrawing::Kind::kCircle);
  CHECK(got.drawings[1].radius == 0.7);
  CHECK(same(got.drawings[2].from, {0.8, 0.9}));
  CHECK(got.drawings[2].text == "here");
}

TEST_CASE("a place to drive to comes back whole", "[unit]") {
  team::Commands commands;
  team::GoTo place;
  place.position = {0.5, -0.25};
  place.heading = 1.25;
  place.stop = true;
  place.speed_limit = 0.75;
  place.avoid_ball = true;
  place.avoid_mates = false;
  place.avoid_opponents = false;
  place.tolerance = 0.0625;
  place.either_front = false;
  place.navigator = 3;
  commands.goTo(10, place);
  const TeamCommand got = throughAbi(commands);
  CHECK(got.robots[10].kind == RobotCommand::Kind::kGoTo);
  const GoTo& go_to = got.robots[10].go_to;
  CHECK(same(go_to.position, place.position));
  CHECK(go_to.heading == 1.25);
  CHECK(go_to.stop);
  CHECK(go_to.speed_limit == 0.75);
  CHECK(go_to.avoid_ball);
  CHECK_FALSE(go_to.avoid_mates);
  CHECK_FALSE(go_to.avoid_opponents);
  CHECK(go_to.tolerance == 0.0625);
  CHECK_FALSE(go_to.either_front);
  CHECK(go_to.navigator == 3);
}

TEST_CASE("a command that a team leaves alone is the simulator's default", "[unit]") {
  CommandRoom room;
  TeamCommand got;
  fromAbi(room.open(false), kMaxTeamSize, got);
  const GoTo by_default;
  for (const RobotCommand& robot : got.robots) {
    CHECK(robot.kind == RobotCommand::Kind::kWheels);
    CHECK(robot.wheels.left == 0.0);
    CHECK(robot.go_to.speed_limit == by_default.speed_limit);
    CHECK(robot.go_to.tolerance == by_default.tolerance);
    CHECK(robot.go_to.avoid_ball == by_default.avoid_ball);
    CHECK(robot.go_to.avoid_mates == by_default.avoid_mates);
    CHECK(robot.go_to.avoid_opponents == by_default.avoid_opponents);
    CHECK(robot.go_to.either_front == by_default.either_front);
  }
  CHECK(got.drawings.empty());
  fulbito_team_command abi = room.open(false);
  team::detail::give({}, kMaxTeamSize, abi);
  TeamCommand from_class;
  fromAbi(abi, kMaxTeamSize, from_class);
  CHECK(from_class.robots[4].go_to.speed_limit == std::numeric_limits<double>::infinity());
  CHECK(from_class.robots[4].go_to.tolerance == by_default.tolerance);
}

TEST_CASE("placements come back whole", "[unit]") {
  team::Placement wish;
  wish.robots[2] = team::Pose{{-0.5, 0.25}, 1.5};
  wish.ball = team::Vec2{0.125, 0.375};
  fulbito_placement abi{};
  team::detail::give(wish, abi);
  const TeamProposal got = fromAbi(abi);
  CHECK_FALSE(got.robots[0]);
  REQUIRE(got.robots[2]);
  CHECK(same(*got.robots[2], *wish.robots[2]));
  REQUIRE(got.ball);
  CHECK(same(*got.ball, *wish.ball));
  CHECK_FALSE(fromAbi(fulbito_placement{}).ball);
}

TEST_CASE("a long name is cut between characters and ends with a zero byte", "[unit]") {
  char name[FULBITO_NAME_SIZE];
  toAbi(std::string(62, 'a') + "\xc3\xa9", name);
  CHECK(std::string(name) == std::string(62, 'a'));
  toAbi(std::string(200, 'b'), name);
  CHECK(std::string(name) == std::string(63, 'b'));
}

}  // namespace fulbito
