#include "match/play/restart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "referee/restarts/restart_call.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

struct Starts final : MatchObserver {
  struct Start {
    RestartCall call;
    Placement placement;
    int repairs = 0;
    bool legal = false;
  };
  const MatchConfig* config = nullptr;
  std::vector<Start> starts;

  void onMatchStart(const MatchConfig& from) override { config = &from; }
  void onPlayStart(const PlayStart& start) override {
    RefereeSetup setup;
    setup.rules = config->rules;
    setup.field = config->field;
    setup.robot = config->robot.robot;
    setup.ball = config->robot.ball;
    starts.push_back({start.call, start.placement, static_cast<int>(start.events.size()),
                      legalPlacement(setup, *start.referee, start.call, start.placement)});
  }
};

/// The first play of a match.
Starts::Start firstStart(const MatchConfig& config) {
  auto match = Match::create(config);
  REQUIRE(match);
  Starts starts;
  match->watch(starts);
  match->step();
  return starts.starts.front();
}

TeamCommand stand(const Observation&) { return {}; }

}  // namespace

TEST_CASE("teams place in their own frame, the second one seeing the first", "[unit]") {
  struct Asked {
    bool ours;
    TeamPlacement defaults;
    std::optional<TeamPlacement> opponents;
  };
  std::vector<Asked> asked;
  const Place place = [&](const PlacementRequest& request) {
    CHECK(request.kind == RestartKind::kKickOff);
    asked.push_back({request.ours, request.defaults, request.opponents});
    TeamPlacement wish;
    wish[1] = Pose2{{-0.5, 0.3}, 1.0};
    return wish;
  };
  const TestEntry entry(stand, place);
  MatchConfig config = shortMatch();
  config.teams = {entry.choice(), entry.choice()};
  config.placement_error = {0.0, 0.0};
  const Starts::Start start = firstStart(config);
  REQUIRE(asked.size() == 2);
  CHECK(asked[0].ours);
  CHECK_FALSE(asked[0].opponents);
  CHECK_FALSE(asked[1].ours);
  REQUIRE(asked[1].opponents);
  CHECK((*asked[1].opponents)[1]->position.x == Approx(0.5));
  CHECK((*asked[1].opponents)[1]->position.y == Approx(-0.3));
  CHECK(asked[1].defaults[0]->position.x < 0.0);
  CHECK(start.legal);
  CHECK(start.repairs == 0);
  const auto& robots = start.placement.robots;
  CHECK(robots[0][1]->position == Vec2{-0.5, 0.3});
  CHECK(robots[1][1]->position == Vec2{0.5, -0.3});
  CHECK(robots[0][1]->heading == Approx(1.0));
  CHECK(robots[1][1]->heading == Approx(1.0 - math::kPi));
  CHECK(robots[0][0]->position.x == Approx(asked[0].defaults[0]->position.x).margin(1e-12));
}

TEST_CASE("impossible wishes are repaired and told once each", "[unit]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Place place = [&](const PlacementRequest&) {
    TeamPlacement wish;
    wish[0] = Pose2{{nan, 0.0}, 0.0};
    wish[1] = Pose2{{0.6, 0.0}, 0.0};  // the opponents' half
    wish[2] = Pose2{{-1e300, 0.0}, 0.0};
    wish[7] = Pose2{{-0.3, 0.0}, 0.0};  // there is no such robot
    return wish;
  };
  const TestEntry entry(stand, place);
  MatchConfig config = shortMatch();
  config.teams = {entry.choice(), entry.choice()};
  const Starts::Start start = firstStart(config);
  CHECK(start.legal);
  CHECK(start.repairs == 6);
  CHECK_FALSE(start.placement.robots[0][7]);
}

TEST_CASE("robots stand a little off their places, legally and by the seed", "[unit]") {
  MatchConfig config = shortMatch();
  config.placement_error = {0.0, 0.0};
  const Placement exact = firstStart(config).placement;
  config.placement_error = {0.003, 0.05};
  double most = 0.0, turned = 0.0;
  int moved = 0;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    config.seed = seed;
    const Starts::Start start = firstStart(config);
    CHECK(start.legal);
    for (std::size_t team = 0; team < 2; ++team) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Pose2 &is = *start.placement.robots[team][i], &should = *exact.robots[team][i];
        const Vec2 off = is.position - should.position;
        if (norm(off) > 0.01) continue;  // the toss gave the kick-off to the other team
        most = std::max({most, std::abs(off.x), std::abs(off.y)});
        turned = std::max(turned, std::abs(math::wrapAngle(is.heading - should.heading)));
        moved += norm(off) > 0.0 ? 1 : 0;
      }
    }
  }
  CHECK(most <= 0.003);
  CHECK(most > 0.0025);
  CHECK(turned <= 0.05);
  CHECK(turned > 0.04);
  CHECK(moved > 100);
}

TEST_CASE("every restart of a match is legal", "[unit]") {
  const std::string rules = GENERATE("vsss-3v3", "vsss-5v5", "training");
  MatchConfig config = shortMatch();
  config.rules = *loadRules(rules);
  config.rules.half_seconds = 60.0;
  config.field = *loadField(config.rules.field);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    config.seed = seed;
    auto match = Match::create(config);
    REQUIRE(match);
    Starts starts;
    match->watch(starts);
    while (match->step()) {
    }
    CHECK_FALSE(match->faults().abandoned);
    for (const Starts::Start& start : starts.starts) CHECK(start.legal);
  }
}

TEST_CASE("robots held before the signal do not move, free ones do", "[unit]") {
  const TestEntry entry([](const Observation&) { return allWheels({-40.0, -40.0}); });
  MatchConfig config = shortMatch();
  config.teams = {entry.choice(), entry.choice()};
  config.rules.restart.delay = 0.2;
  config.rules.restart.hold_robots = GENERATE(true, false);
  auto match = Match::create(config);
  REQUIRE(match);
  match->makeReady();
  const Vec2 before = match->world().robots[1].pose.position;
  for (int i = 0; i < 5; ++i) {
    REQUIRE(match->step());
    CHECK_FALSE(match->referee().playing);
    CHECK(match->referee().play_ticks == 0);
  }
  const bool moved = distance(before, match->world().robots[1].pose.position) > 0.005;
  CHECK(moved != config.rules.restart.hold_robots);
}

namespace {

/// Observes the ticks between placement and signal.
struct Waiting final : MatchObserver {
  Placement placed;
  Tick play_ticks = 0;
  Tick waited = 0, plays = 0;
  double ball_moved = 0.0, robot_moved = 0.0, robot_speed = 0.0;
  bool clock_ran = false;

  void onPlayStart(const PlayStart& start) override {
    placed = start.placement;
    play_ticks = start.referee->play_ticks;
    waiting_ = !start.referee->playing;
    ++plays;
  }
  void onTick(const MatchTick& tick) override {
    if (!waiting_) return;
    ++waited;
    clock_ran = clock_ran || tick.referee->play_ticks != play_ticks;
    const BallState& ball = tick.world->balls.front();
    ball_moved = std::max(ball_moved, distance(ball.position, placed.ball));
    for (std::size_t i = 0; i < tick.ids.size(); ++i) {
      const RobotState& robot = tick.world->robots[i];
      const Vec2 from = placed.robots[indexOf(tick.ids[i].team)][tick.ids[i].number]->position;
      robot_moved = std::max(robot_moved, distance(robot.pose.position, from));
      robot_speed = std::max(robot_speed, norm(robot.velocity));
    }
    waiting_ = !tick.referee->playing;
  }

 private:
  bool waiting_ = false;
};

}  // namespace

TEST_CASE("with the profiles' delays ball, robots and clock stand still until the signal", "[unit]") {
  const std::string rules = GENERATE("vsss-3v3", "vsss-5v5");
  MatchConfig config = shortMatch("random", "libero");
  config.rules = *loadRules(rules);
  CHECK(config.rules.restart.delay > 0.0);
  CHECK(config.rules.restart.goal_delay > 0.0);
  CHECK(config.rules.restart.hold_robots);
  config.rules.free_ball.others = FreeBallOthers::kTable;  // robots that may stay may also overlap
  config.rules.half_seconds = 60.0;
  config.field = *loadField(config.rules.field);
  auto match = Match::create(config);
  REQUIRE(match);
  Waiting waiting;
  match->watch(waiting);
  while (match->step()) {
  }
  CHECK(match->referee().ended);
  CHECK(match->referee().match_ticks == 2 * 3600);
  CHECK(waiting.plays > 4);
  const double dt = config.physics.controlPeriod();
  CHECK(static_cast<double>(waiting.waited) * dt ==
        Approx(static_cast<double>(waiting.plays) * config.rules.restart.delay));
  CHECK(match->tick() == match->referee().match_ticks + waiting.waited);
  CHECK_FALSE(waiting.clock_ran);
  CHECK(waiting.ball_moved < 1e-6);
  CHECK(waiting.robot_moved < 1e-6);
  CHECK(waiting.robot_speed < 1e-6);
}

TEST_CASE("the taking team chooses where a goal kick's ball lies, and the other team is told", "[unit]") {
  std::vector<Vec2> told;
  const Vec2 wish{-0.64, -0.21};
  const Place place = [&](const PlacementRequest& request) {
    TeamProposal proposal(request.defaults);
    if (request.ours) proposal.ball = wish;
    told.push_back(request.ball);
    return proposal;
  };
  const TestEntry entry(stand, place);
  MatchConfig config = shortMatch();
  config.teams = {entry.choice(), entry.choice()};
  const RefereeSetup setup = refereeSetup(config);
  for (const TeamId team : kTeams) {
    told.clear();
    config.opening = makeCall(setup, {}, {RestartKind::kGoalKick, team, {}, nullptr});
    const Starts::Start start = firstStart(config);
    REQUIRE(told.size() == 2);
    CHECK(distance(told[1], -wish) < 1e-9);
    CHECK(distance(start.placement.ball, team == TeamId::kBlue ? wish : -wish) < 1e-9);
    CHECK(start.call.ball == start.placement.ball);
    CHECK(start.legal);
    // The keeper's default place is for the ball's place in the table, so it stays there.
    CHECK(start.repairs == 0);
  }
}

TEST_CASE("a state that no world can be made of is an error, not an empty field", "[unit]") {
  const MatchConfig config = shortMatch();
  RestartCall call;
  Placement placement = twoColumns();
  REQUIRE(makePlay(config, call, placement));
  placement.ball = {2.0, 0.0};
  CHECK(makePlay(config, call, placement).error().message == "ball 0: position (2, 0) is outside the field");
  placement.ball = {};
  placement.robots[1][2]->position.y = std::numeric_limits<double>::infinity();
  CHECK(makePlay(config, call, placement).error().message.rfind("robot 5: position", 0) == 0);
}

TEST_CASE("a team that did not come has no robots", "[unit]") {
  MatchConfig config = shortMatch();
  config.present = {true, false};
  auto match = Match::create(config);
  REQUIRE(match);
  match->makeReady();
  CHECK(match->ids().size() == 3);
  for (const RobotId id : match->ids()) CHECK(id.team == TeamId::kBlue);
  while (match->step()) {
  }
  CHECK(match->referee().ended);
}

}  // namespace fulbito
