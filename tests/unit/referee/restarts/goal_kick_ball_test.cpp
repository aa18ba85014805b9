#include "referee/restarts/goal_kick_ball.hpp"

#include <cmath>
#include <limits>

#include "engine/core/math/random.hpp"
#include "fulbito/detail/math.hpp"
#include "referee/restarts/restart_call.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/referee/referee_samples.hpp"

namespace fulbito {
namespace {

using testing::setupOf;

RestartCall goalKick(const RefereeSetup& setup, const RefereeState& state, TeamId team) {
  return makeCall(setup, state, {RestartKind::kGoalKick, team, {}, nullptr});
}

bool inArea(const RefereeSetup& setup, const RefereeState& state, TeamId team, Vec2 ball) {
  const AreaShape grown_by_rounding = grown(goalAreaOf(setup.field, setup.rules.areas.arc), 1e-9);
  const Vec2 there = intoGoalFrame(setup.field, state.sideOf(team), ball);
  return contains(grown_by_rounding, there) && there.x >= setup.ball.radius;
}

}  // namespace

TEST_CASE("law 13: the ball lies anywhere in the area that its team wants", "[unit]") {
  const RefereeSetup setup = setupOf("vsss-3v3");
  const RefereeState state;
  const RestartCall call = goalKick(setup, state, TeamId::kBlue);
  // On the front line, deep at the side, before the mouth, in the arc.
  for (const Vec2 wish : {Vec2{-0.60, -0.35}, Vec2{-0.72, 0.34}, Vec2{-0.65, 0.0}, Vec2{-0.56, 0.02}}) {
    std::vector<GameEvent> log;
    const RestartCall moved = withBall(setup, state, call, wish, log);
    CHECK(distance(moved.ball, wish) < 1e-12);
    CHECK(log.empty());
    const Placement placement = place(setup, state, moved, {}, log);
    CHECK(placement.ball == moved.ball);
    CHECK(legalPlacement(setup, state, moved, placement));
    // The keeper comes with it, between it and the goal, and looks at it.
    const Pose2 keeper = *placement.robots[0][0];
    CHECK(distance(keeper.position, moved.ball) < 0.16);
    CHECK(distance(keeper.position, {-0.75, 0.0}) < distance(moved.ball, {-0.75, 0.0}));
    CHECK(math::cos(keeper.heading - math::angleOf(moved.ball - keeper.position)) == Approx(1.0));
  }
}

TEST_CASE("a ball that is wanted elsewhere lies at the area's nearest place, and the record says so",
          "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::string profile : {"vsss-3v3", "vsss-5v5"}) {
    const RefereeSetup setup = setupOf(profile);
    for (const TeamId team : kTeams) {
      const RefereeState state;
      const RestartCall call = goalKick(setup, state, team);
      Rng rng(5, test::kTestStream);
      for (int i = 0; i < 500; ++i) {
        const Vec2 wish{rng.uniform(-2.0, 2.0), rng.uniform(-2.0, 2.0)};
        std::vector<GameEvent> log;
        const RestartCall moved = withBall(setup, state, call, wish, log);
        REQUIRE(inArea(setup, state, team, moved.ball));
        REQUIRE(moved.defaults.ball == moved.ball);
        const double off = distance(moved.ball, wish);
        // Nothing in the area is clearly nearer.
        for (int k = 0; k < 20; ++k) {
          const Vec2 other{rng.uniform(-1.1, 1.1), rng.uniform(-0.4, 0.4)};
          if (inArea(setup, state, team, other)) REQUIRE(distance(other, wish) > off - 2e-4);
        }
        REQUIRE(log.size() == (off >= 1e-3 ? 1u : 0u));
        if (log.empty()) continue;
        REQUIRE(log[0].clause == "placement");
        REQUIRE(log[0].team == team);
        REQUIRE_FALSE(log[0].robot);
        REQUIRE(log[0].value == Approx(off));
      }
      std::vector<GameEvent> log;
      CHECK(withBall(setup, state, call, {nan, 0.0}, log).ball == call.ball);
      CHECK(log.size() == 1);
    }
  }
}

TEST_CASE("where the ball has its spot it stays there", "[unit]") {
  RefereeSetup setup = setupOf("vsss-3v3");
  const RefereeState state;
  std::vector<GameEvent> log;
  const RestartCall kick_off = makeCall(setup, state, {RestartKind::kKickOff, TeamId::kBlue, {}, nullptr});
  CHECK(withBall(setup, state, kick_off, {0.1, 0.0}, log).ball == Vec2{});
  CHECK(log.size() == 1);
  setup.rules.goal_kick.ball_free = false;
  const RestartCall call = goalKick(setup, state, TeamId::kYellow);
  CHECK(withBall(setup, state, call, {0.65, 0.1}, log).ball == call.ball);
  CHECK(log.size() == 2);
  CHECK(withBall(setup, state, call, call.ball, log).defaults.robots[1][0]->position == Vec2{0.675, 0.27});
  CHECK(log.size() == 2);
}

TEST_CASE("left to the rules, the ball lies on the side that opponents are farther from", "[unit]") {
  const RefereeState state;
  for (const double y : {0.5, -0.5}) {
    const std::vector<RobotId> ids{{TeamId::kBlue, 0}, {TeamId::kYellow, 1}, {TeamId::kYellow, 2}};
    const std::vector<RobotState> robots{{{{-0.7, y / 5}, 0.0}, {}, 0.0, {}},
                                         {{{-0.4, y}, 0.0}, {}, 0.0, {}},
                                         {{{0.5, -y}, 0.0}, {}, 0.0, {}}};
    const MatchView view{1, ids, robots, {}, {}};
    RefereeSetup setup = setupOf("vsss-3v3");
    const Stoppage stoppage{RestartKind::kGoalKick, TeamId::kBlue, {}, &view, 0};
    CHECK(makeCall(setup, state, stoppage).ball == Vec2{-0.60, y > 0.0 ? -0.35 : 0.35});
    setup.rules.goal_kick.side = GoalKickSide::kKeeper;
    CHECK(makeCall(setup, state, stoppage).ball == Vec2{-0.60, y > 0.0 ? 0.35 : -0.35});
  }
}

TEST_CASE("at a goal kick opponents stand in their own half, or anywhere but in the area", "[unit]") {
  RefereeSetup setup = setupOf("vsss-3v3");
  const RefereeState state;
  const RestartCall call = goalKick(setup, state, TeamId::kBlue);
  TeamPoses wish = defaultPoses(call, TeamId::kYellow);
  wish[1] = Pose2{call.ball + Vec2{0.04, 0.069}, 0.0};
  std::vector<GameEvent> log;
  Placement placement = place(setup, state, call, {std::nullopt, wish}, log);
  CHECK(placement.robots[1][1]->position.x >= setup.robot.length / 2);
  CHECK(log.size() == 1);
  setup.rules.goal_kick.opponents = GoalKickOpponents::kOutsideArea;
  placement = place(setup, state, call, {std::nullopt, wish}, log);
  CHECK(placement.robots[1][1]->position == wish[1]->position);
  placement.robots[1][1]->position = {-0.56, 0.0};
  const auto flaw = findPlacementFlaw(setup, state, call, placement);
  REQUIRE(flaw);
  CHECK(flaw->reason == "is in the kicking team's goal area");
}

}  // namespace fulbito
