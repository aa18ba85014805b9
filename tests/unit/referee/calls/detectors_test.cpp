#include "referee/calls/detectors.hpp"

#include <limits>

#include "engine/core/math/random.hpp"
#include "fulbito/models.hpp"
#include "fulbito/referee.hpp"
#include "fulbito/world.hpp"
#include "referee/rules/detector_schema.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/worlds.hpp"

namespace fulbito {
namespace {

RefereeSetup bookSetup() {
  RefereeSetup setup;
  setup.robot = loadRobot("vsss").value().robot;
  setup.ball = loadRobot("vsss").value().ball;
  setup.rules.fouls.push = true;
  setup.rules.fouls.holding = true;
  return setup;
}

std::vector<RobotId> threeAgainstThree() {
  std::vector<RobotId> ids;
  for (const TeamId team : kTeams) {
    for (std::uint8_t i = 0; i < 3; ++i) ids.push_back({team, i});
  }
  return ids;
}

}  // namespace

TEST_CASE("detectors allocate nothing", "[unit]") {
  const RefereeSetup setup = bookSetup();
  RefereeState state;
  DetectorMemory memory;
  const std::vector<RobotId> ids = threeAgainstThree();
  World world = test::makeWorld(
      test::matchConfig(loadRobot("vsss").value(), loadPhysics("standard").value(), 3, setup.field));
  std::vector<WheelSpeeds> commands(6);
  int calls = 0;
  std::uint64_t allocated = 0;
  for (Tick tick = 1; tick <= 3000; ++tick) {
    const WorldState& now = world.state();
    for (std::size_t i = 0; i < 6; ++i) {
      commands[i] = test::chase(now.robots[i], now.balls.front().position);
    }
    world.step(commands);
    const std::uint64_t before = test::allocationCount();
    const auto call =
        detect({tick, ids, now.robots, now.balls.front(), world.contacts()}, setup, state, memory);
    allocated += test::allocationCount() - before;
    if (!call) continue;
    ++calls;
    memory = {};
    state.play_began = tick;
  }
  CHECK(calls > 0);
  CHECK(allocated == 0);
}

TEST_CASE("detectors bear states that are not finite and views of odd sizes", "[unit]") {
  const RefereeSetup setup = bookSetup();
  const RefereeState state;
  DetectorMemory memory;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  std::vector<RobotId> ids = threeAgainstThree();
  std::vector<RobotState> robots(6);
  robots[1].pose = {{nan, 0.0}, nan};
  BallState ball;
  ball.position = {nan, nan};
  const std::vector<ContactEvent> contacts = {
      {{BodyKind::kRobot, 99}, {BodyKind::kBall, 0}, {}, {1.0, 0.0}, 1.0, true},
      {{BodyKind::kRobot, 0}, {BodyKind::kRobot, 99}, {}, {1.0, 0.0}, 1.0, true},
      {{BodyKind::kWall, 0}, {BodyKind::kRobot, 2}, {}, {1.0, 0.0}, 1.0, true}};
  for (Tick tick = 1; tick <= 100; ++tick) {
    CHECK_FALSE(detect({tick, ids, robots, ball, contacts}, setup, state, memory));
  }
  ids.resize(3);
  CHECK_FALSE(detect({101, ids, robots, ball, contacts}, setup, state, memory));
  robots.assign(40, {});
  ids.assign(40, {});
  CHECK_FALSE(detect({102, ids, robots, ball, contacts}, setup, state, memory));
}

TEST_CASE("the tables of the detectors refuse what makes no sense", "[unit]") {
  CHECK_FALSE(findFlaw(GoalRules{}));
  CHECK_FALSE(findFlaw(StuckRules{}));
  CHECK_FALSE(findFlaw(AreaRules{}));
  CHECK_FALSE(findFlaw(KeeperRules{}));
  CHECK_FALSE(findFlaw(FoulRules{}));
  StuckRules stuck;
  stuck.release_speed = 0.05;
  REQUIRE(findFlaw(stuck));
  CHECK(findFlaw(stuck)->key == "release_speed");
  AreaRules areas;
  areas.attackers_max = 12;
  CHECK(findFlaw(areas)->key == "attackers_max");
  KeeperRules keeper;
  keeper.hold_seconds = std::numeric_limits<double>::quiet_NaN();
  CHECK(findFlaw(keeper)->key == "hold_seconds");
  FoulRules fouls;
  fouls.pinned_speed = -1.0;
  CHECK(findFlaw(fouls)->key == "pinned_speed");
}

TEST_CASE("every key of the detectors has a meaning and a source", "[unit]") {
  Rules rules;
  for (const Schema& schema : {schemaOf(rules.goal), schemaOf(rules.stuck), schemaOf(rules.areas),
                               schemaOf(rules.keeper), schemaOf(rules.fouls)}) {
    for (const SchemaKey& key : schema) {
      INFO(key.key << ": " << key.doc);
      const bool sourced =
          key.doc.find("law") != std::string::npos || key.doc.find("ours") != std::string::npos ||
          key.doc.find("program") != std::string::npos || key.doc.find("text") != std::string::npos;
      CHECK(sourced);
    }
  }
}

}  // namespace fulbito
