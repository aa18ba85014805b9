#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Log final : MatchObserver {
  std::vector<GameEvent> events;
  WheelSpeeds first_blue, last_yellow;
  void onTick(const MatchTick& tick) override {
    for (const GameEvent& event : tick.events) {
      if (event.law == "policy") events.push_back(event);
    }
    first_blue = tick.commands.front();
    last_yellow = tick.commands.back();
  }
};

/// A match of 100 ticks of a team against one that stands still.
struct Played {
  explicit Played(const Decide& decide, std::vector<NavigatorChoice> navigators = {}) {
    const TestEntry entry(decide, {}, std::move(navigators));
    const TestEntry still([](const Observation&) { return TeamCommand{}; });
    MatchConfig config = shortMatch();
    config.teams = {still.choice(), entry.choice()};
    config.start = twoColumns();
    auto match = Match::create(config);
    REQUIRE(match);
    match->watch(log);
    for (int i = 0; i < 100; ++i) REQUIRE(match->step());
    CHECK(match->faults().teams[0].rejected() == 0);
    faults = match->faults().teams[1];
    for (const RobotState& robot : match->world().robots) finite &= isFinite(robot.pose.position);
  }
  Log log;
  TeamFaults faults;
  bool finite = true;
};

TeamCommand first(const RobotCommand& command) {
  TeamCommand all;
  all.robots[2] = command;
  return all;
}

std::string eventsOf(const Log& log) {
  std::string text;
  for (const GameEvent& event : log.events) {
    text += std::string(event.clause) + ' ' + std::to_string(static_cast<int>(event.value)) + ' ';
  }
  return text;
}

}  // namespace

TEST_CASE("a robot whose command is not finite stands still, is counted and told of ever less often",
          "[unit]") {
  GoTo nowhere;
  nowhere.position = {0.0, kNaN};
  GoTo no_heading;
  no_heading.heading = kInfinity;
  GoTo no_speed;
  no_speed.speed_limit = kNaN;
  const RobotCommand bad =
      GENERATE_COPY(RobotCommand::byWheels({kNaN, 1.0}), RobotCommand::byWheels({1.0, -kInfinity}),
                    RobotCommand::byTwist({kNaN, 0.0}), RobotCommand::byTwist({0.0, kInfinity}),
                    RobotCommand::drivingTo(nowhere), RobotCommand::drivingTo(no_heading),
                    RobotCommand::drivingTo(no_speed));
  const Played played([&](const Observation&) { return first(bad); }, {*parseNavigator("straight")});
  CHECK(played.faults.not_finite == 100);
  CHECK(played.faults.rejected() == 100);
  CHECK(eventsOf(played.log) == "command.not-finite 1 command.not-finite 10 command.not-finite 100 ");
  CHECK(played.log.events[0].team == TeamId::kYellow);
  CHECK(played.log.events[0].robot == 2);
  CHECK(played.log.events[1].tick == 9);
  CHECK(played.log.last_yellow.left == 0.0);
  CHECK(played.finite);
}

TEST_CASE("wheels beyond the motors are cut and rounded, which is no fault", "[unit]") {
  const Played played([](const Observation&) { return first(RobotCommand::byWheels({1e300, -47.0})); });
  CHECK(played.faults.saturated == 100);
  CHECK(played.faults.rejected() == 0);
  CHECK(played.log.events.empty());
  CHECK(played.log.last_yellow.left == Approx(46.08));
  CHECK(played.log.last_yellow.right == Approx(-46.08));
}

TEST_CASE("commands are rounded before they are applied and reported", "[unit]") {
  const Played played([](const Observation&) { return first(RobotCommand::byWheels({1.234, -5.678})); });
  CHECK(played.log.last_yellow.left == Approx(1.23).epsilon(1e-12));
  CHECK(played.log.last_yellow.right == Approx(-5.68).epsilon(1e-12));
}

TEST_CASE("a place far off the field is taken to its edge, a navigator that is not there stops", "[unit]") {
  GoTo far;
  far.position = {1e300, -1e300};
  const Played cut([&](const Observation&) { return first(RobotCommand::drivingTo(far)); },
                   {*parseNavigator("univector")});
  CHECK(cut.faults.saturated == 100);
  CHECK(cut.finite);
  GoTo unknown;
  unknown.navigator = 1;
  const Played stopped([&](const Observation&) { return first(RobotCommand::drivingTo(unknown)); },
                       {*parseNavigator("univector")});
  CHECK(stopped.faults.no_navigator == 100);
  CHECK(stopped.log.last_yellow.left == 0.0);
  CHECK(eventsOf(stopped.log) == "command.no-navigator 1 command.no-navigator 10 command.no-navigator 100 ");
}

namespace {

/// A clock that moves only during decisions, or by the test.
struct Thinking {
  std::int64_t now = 0;                     ///< [ns]
  std::function<double(Tick)> yellow;       ///< [s] duration of yellow's decision of the tick
  std::function<void(std::int64_t&)> pace;  ///< the wait between two ticks
  DecisionTime limit;
  int ticks = 100;
  double half_seconds = 5.0;
  std::vector<WheelSpeeds> applied;  ///< applied commands of yellow's last robot
  TeamFaults blue_faults, faults;
  Tick played = 0;
  std::string events;

  void play() {
    const TestEntry quick([](const Observation&) { return TeamCommand{}; });
    const TestEntry slow([this](const Observation& seen) {
      now += static_cast<std::int64_t>(yellow(seen.tick) * 1e9);
      return allWheels({static_cast<double>(seen.tick % 40) + 1.0, 0.0});
    });
    MatchConfig config = shortMatch("idle", "idle", half_seconds);
    config.teams = {quick.choice(), slow.choice()};
    config.start = twoColumns();
    config.decision_time = limit;
    auto match = Match::create(config, [this] { return now; });
    REQUIRE(match);
    if (pace) match->pace([this](Tick) { pace(now); });
    Log log;
    match->watch(log);
    for (int i = 0; i < ticks && match->step(); ++i) applied.push_back(log.last_yellow);
    blue_faults = match->faults().teams[0];
    faults = match->faults().teams[1];
    played = match->tick();
    events = eventsOf(log);
  }
};

}  // namespace

TEST_CASE("a late decision leaves the one before in force, and after too many the robots stand", "[unit]") {
  Thinking match;
  match.limit = {0.02, 0.0, 30};
  match.yellow = [](Tick tick) { return tick < 10 || tick >= 60 ? 0.02 : 0.021; };
  match.play();
  CHECK(match.blue_faults.late == 0);
  CHECK(match.faults.late == 50);
  CHECK(match.faults.rejected() == 50);
  CHECK(match.events == "command.late 1 command.late 10 ");
  CHECK(match.applied[9].left == Approx(10.0));
  CHECK(match.applied[10].left == Approx(10.0));
  CHECK(match.applied[39].left == Approx(10.0));  // the thirtieth in a row
  CHECK(match.applied[40].left == 0.0);
  CHECK(match.applied[59].left == 0.0);
  CHECK(match.applied[60].left == Approx(21.0));
}

TEST_CASE("the first decision has none before: the robots stand", "[unit]") {
  Thinking match;
  match.limit = {0.0, 0.0, 30};
  match.yellow = [](Tick) { return 0.001; };
  match.play();
  CHECK(match.faults.late == 100);
  for (const WheelSpeeds& wheels : match.applied) CHECK(wheels.left == 0.0);
}

TEST_CASE("what a decision takes too long is paid from a bank, which is full again in each period",
          "[unit]") {
  Thinking match;
  match.limit = {0.125, 1.25, 30};
  match.half_seconds = 1.0;
  match.ticks = 1000;
  match.yellow = [](Tick) { return 0.25; };  // the bank covers ten of them
  match.play();
  CHECK(match.played >= 120);
  CHECK(match.faults.late == match.played - 2 * 10);
}

TEST_CASE("waiting is not thinking", "[unit]") {
  Thinking match;
  match.limit = {0.02, 0.0, 30};
  match.yellow = [](Tick) { return 0.01; };
  match.pace = [](std::int64_t& now) { now += 1'000'000'000; };
  match.play();
  CHECK(match.faults.late == 0);
  CHECK(match.now == 101'000'000'000);  // all ticks waited
}

TEST_CASE("whatever two teams command, the match goes on to its end", "[unit]") {
  const double wild[] = {0.0, -0.0, kNaN, kInfinity, -kInfinity, 1e300, -1e300, 1e-310, 3.0, -20.0, 0.5};
  Rng random(7, kTestStream);
  const auto any = [&] { return wild[random.below(std::size(wild))]; };
  const Decide decide = [&](const Observation&) {
    TeamCommand command;
    for (RobotCommand& robot : command.robots) {
      robot.kind = static_cast<RobotCommand::Kind>(random.below(4));
      robot.wheels = {any(), any()};
      robot.twist = {any(), any()};
      robot.go_to.position = {any(), any()};
      if (random.below(2) == 0) robot.go_to.heading = any();
      robot.go_to.tolerance = any();
      robot.go_to.speed_limit = any();
      robot.go_to.stop = random.below(2) == 0;
      robot.go_to.avoid_ball = random.below(2) == 0;
      robot.go_to.navigator = static_cast<std::uint8_t>(random.below(5));
    }
    return command;
  };
  const Place place = [&](const PlacementRequest&) {
    TeamPlacement poses;
    for (auto& pose : poses) pose = Pose2{{any(), any()}, any()};
    return poses;
  };
  const TestEntry entry(decide, place,
                        {*parseNavigator("univector"), *parseNavigator("bezier"), *parseNavigator("dwa"),
                         *parseNavigator("straight")});
  MatchConfig config = shortMatch("chaser", "chaser", 10.0);
  config.teams = {entry.choice(), entry.choice()};
  auto match = Match::create(config);
  REQUIRE(match);
  while (match->step()) {
    for (const RobotState& robot : match->world().robots) REQUIRE(isFinite(robot.pose.position));
  }
  CHECK(match->referee().ended);
  CHECK_FALSE(match->faults().abandoned);
  CHECK(match->faults().teams[0].not_finite > 1000);
}

}  // namespace fulbito
