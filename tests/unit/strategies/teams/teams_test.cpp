#include <cmath>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "fulbito/strategy.hpp"
#include "fulbito/world.hpp"
#include "strategies/interface/team_frame.hpp"
#include "strategies/team_pilots.hpp"
#include "tests/support/allocation_counter.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/strategies/match_info.hpp"

namespace fulbito {
namespace {

/// One team alone on the field against robots that do not move.
struct Game {
  MatchInfo info = test::matchInfo();
  std::unique_ptr<Strategy> team;
  TeamPilots pilots;
  World world;
  Observation seen;

  Game(const std::string& specification, int size, std::uint64_t seed)
      : team(std::move(*makeTeam(*parseTeam(specification)))),
        pilots(start(size, seed)),
        world(std::move(*World::create(placed(seed)))) {}

  TeamPilots start(int size, std::uint64_t seed) {
    if (size == 5) info.field = *loadField("vsss-5v5");
    info.rules.team_size = size;
    info.seed = seed;
    team->begin(info);
    return std::move(*TeamPilots::create(info, team->navigators()));
  }

  WorldConfig placed(std::uint64_t seed) const {
    WorldConfig config{info.field, info.physics, {}, {}, {}};
    Rng rng(seed, test::kTestStream);
    for (int i = 0; i < 2 * info.rules.team_size; ++i) {
      const double x = (i < info.rules.team_size ? -1.0 : 1.0) * (0.2 + 0.1 * (i % info.rules.team_size));
      const double y = -0.4 + 0.2 * (i % info.rules.team_size);
      config.robots.push_back({info.robot, {{x, y}, rng.uniform(-3.0, 3.0)}, {}, 0.0});
    }
    const Vec2 roll{rng.uniform(-0.5, 0.5), rng.uniform(-0.5, 0.5)};
    config.balls.push_back({info.ball, {0.0, rng.uniform(-0.3, 0.3)}, roll, roll});
    return config;
  }

  TeamCommand tick(int number) {
    const auto size = static_cast<std::size_t>(info.rules.team_size);
    const WorldState& now = world.state();
    seen.tick = number;
    seen.dt = info.physics.controlPeriod();
    seen.team_size = info.rules.team_size;
    seen.since_restart = number * seen.dt;
    for (std::size_t i = 0; i < size; ++i) {
      seen.own[i] = {true, now.robots[i]};
      seen.opponents[i] = {true, now.robots[size + i]};
    }
    seen.ball = now.balls[0];
    seen.ball.spin = {};
    TeamCommand command = team->decide(seen);
    const auto wheels = pilots.drive(seen, command);
    world.step({wheels.data(), size});
    for (std::size_t i = 0; i < size; ++i) seen.sent[i] = wheels[i];
    return command;
  }
};

bool isFinite(const RobotCommand& command) {
  return std::isfinite(command.wheels.left) && std::isfinite(command.wheels.right) &&
         std::isfinite(command.twist.linear) && std::isfinite(command.twist.angular) &&
         isFinite(command.go_to.position) && std::isfinite(command.go_to.heading.value_or(0.0));
}

const std::vector<std::string> kSpecifications = {"idle",
                                                  "random",
                                                  "chaser",
                                                  "classic",
                                                  "classic:exchange=on",
                                                  "classic:navigator=limit-cycle:follower=classic"};

}  // namespace

TEST_CASE("teams decide finite commands and repeat themselves", "[unit]") {
  for (const std::string& team : kSpecifications) {
    for (const int size : {3, 5}) {
      CAPTURE(team, size);
      Game a(team, size, 3), b(team, size, 3);
      for (int tick = 0; tick < 600; ++tick) {
        const TeamCommand command = a.tick(tick);
        b.tick(tick);
        for (const RobotCommand& robot : command.robots) REQUIRE(isFinite(robot));
      }
      const WorldState &left = a.world.state(), &right = b.world.state();
      CHECK(left.balls[0].position == right.balls[0].position);
      CHECK(left.robots[0].pose.position == right.robots[0].pose.position);
    }
  }
}

TEST_CASE("a warm team allocates nothing", "[unit]") {
  for (const std::string& team : kSpecifications) {
    CAPTURE(team);
    Game game(team, 3, 5);
    for (int tick = 0; tick < 300; ++tick) game.tick(tick);
    const std::uint64_t before = test::allocationCount();
    for (int tick = 300; tick < 900; ++tick) game.tick(tick);
    CHECK(test::allocationCount() == before);
  }
}

TEST_CASE("random drives differently with another seed, and smoothly", "[unit]") {
  Game a("random", 3, 1), b("random", 3, 2);
  WheelSpeeds last;
  double jumps = 0.0, speeds = 0.0;
  for (int tick = 0; tick < 600; ++tick) {
    const WheelSpeeds wheels = a.tick(tick).robots[1].wheels;
    b.tick(tick);
    jumps += std::abs(wheels.left - last.left);
    speeds += std::abs(wheels.left);
    last = wheels;
  }
  CHECK(jumps < 0.5 * speeds);
  CHECK(speeds / 600 > 5.0);
  CHECK(a.world.state().robots[0].pose.position != b.world.state().robots[0].pose.position);
}

TEST_CASE("classic scores against robots that stand", "[unit]") {
  int goals = 0;
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Game game("classic", 3, seed);
    for (int tick = 0; tick < 900; ++tick) {
      game.tick(tick);
      if (game.world.state().balls[0].position.x > game.info.field.length / 2 + 0.02) {
        ++goals;
        break;
      }
      CHECK(game.world.state().balls[0].position.x > -game.info.field.length / 2 - 0.02);
    }
  }
  CHECK(goals >= 7);
}

TEST_CASE("go-to drives with whichever end is nearer", "[unit]") {
  MatchInfo info = test::matchInfo();
  info.rules.team_size = 1;
  const std::vector<NavigatorChoice> navigators = {*parseNavigator("univector:follower=classic")};
  for (const bool either : {true, false}) {
    TeamPilots pilots = *TeamPilots::create(info, navigators);
    Observation seen;
    seen.team_size = 1;
    seen.own[0].present = true;
    TeamCommand command;
    GoTo go_to;
    go_to.position = {-0.4, 0.02};
    go_to.either_front = either;
    command.robots[0] = RobotCommand::drivingTo(go_to);
    const WheelSpeeds wheels = pilots.drive(seen, command)[0];
    CHECK((wheels.left + wheels.right < -1.0) == either);
  }
}

TEST_CASE("wheels are commanded in 256 speeds each way, a team's own as they are", "[unit]") {
  MatchInfo info = test::matchInfo();
  info.rules.team_size = 1;
  Observation seen;
  seen.team_size = 1;
  seen.dt = info.physics.controlPeriod();
  seen.own[0].present = true;
  const auto driven = [&](const RobotCommand& robot) {
    TeamCommand command;
    command.robots[0] = robot;
    return TeamPilots::create(info, {})->drive(seen, command)[0];
  };
  CHECK(driven(RobotCommand::byWheels({1.237, -60.0})).left == 1.237);
  CHECK(driven(RobotCommand::byTwist({0.0171, 0.0})).left == Approx(0.72).margin(1e-12));  // 0.658 is wanted
  // At top speed the commands stay within the robot's limits.
  seen.own[0].state.velocity = {info.robot.maxSpeed(), 0.0};
  seen.own[0].state.wheels = {info.robot.max_wheel_speed, info.robot.max_wheel_speed};
  CHECK(driven(RobotCommand::byTwist({9.0, 0.0})).right == Approx(46.08));
  info.robot.max_wheel_speed = 46.0;
  CHECK(driven(RobotCommand::byTwist({9.0, 0.0})).right == Approx(45.9));  // steps of 0.17
  info.physics.wheel_command_step = 0.0;
  CHECK(driven(RobotCommand::byTwist({9.0, 0.0})).right == Approx(46.0));
}

}  // namespace fulbito
