#include "match/restart.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/catch.hpp"
#include "tests/unit/match/test_teams.hpp"

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

  void matchBegins(const MatchConfig& from) override { config = &from; }
  void playBegins(const PlayStart& start) override {
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
  const Vec2 before = match->world().robots[1].pose.position;
  for (int i = 0; i < 5; ++i) {
    REQUIRE(match->step());
    CHECK_FALSE(match->referee().playing);
    CHECK(match->referee().play_ticks == 0);
  }
  const bool moved = distance(before, match->world().robots[1].pose.position) > 0.005;
  CHECK(moved != config.rules.restart.hold_robots);
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
  CHECK(match->ids().size() == 3);
  for (const RobotId id : match->ids()) CHECK(id.team == TeamId::kBlue);
  while (match->step()) {
  }
  CHECK(match->referee().ended);
}

}  // namespace fulbito
