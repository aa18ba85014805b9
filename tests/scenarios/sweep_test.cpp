#include <cmath>
#include <functional>

#include "referee/geometry/areas.hpp"
#include "referee/rules/clauses.hpp"
#include "tests/scenarios/scenario.hpp"
#include "tests/support/catch.hpp"

/// Each threshold of the detectors, a millimetre and a tick to both sides of it, in the four variants.
namespace fulbito::test {
namespace {

constexpr double kTick = 1.0 / 60.0;
constexpr double kMillimetre = 1e-3;
constexpr double kHalf = 0.0375;    // [m] of the robot
constexpr double kRadius = 0.0215;  // [m] of the ball
constexpr RobotId kBlue1{TeamId::kBlue, 1}, kBlue2{TeamId::kBlue, 2};
constexpr RobotId kYellow0{TeamId::kYellow, 0}, kYellow1{TeamId::kYellow, 1};

/// Which calls a sweep is about, and the situation `k` steps beyond (or before) the threshold.
struct Sweep {
  std::string_view clause;
  std::function<Scenario(double k)> at;
};

Scenario scene(Vec2 ball, double seconds) {
  Scenario s;
  s.ball = ball;
  s.seconds = seconds;
  s.robots = {
      {{TeamId::kBlue, 0}, {{-0.70, 0.0}, 0.0}, {}}, {kBlue1, {{-0.30, 0.30}, 0.0}, {}},
      {kBlue2, {{-0.30, -0.30}, 0.0}, {}},           {kYellow0, {{0.70, -0.05}, 0.0}, {}},
      {kYellow1, {{0.10, 0.50}, 0.0}, {}},           {{TeamId::kYellow, 2}, {{0.10, -0.50}, 0.0}, {}}};
  return s;
}

ScenarioRobot& robot(Scenario& s, RobotId id) {
  for (ScenarioRobot& r : s.robots) {
    if (r.id == id) return r;
  }
  return s.robots.front();
}

ScenarioMove jump(double at, std::optional<RobotId> id, Vec2 position, double heading = 0.0) {
  ScenarioMove m;
  m.at = at;
  m.robot = id;
  m.position = position;
  m.heading = heading;
  return m;
}

bool calls(const Scenario& s, std::string_view clause, ScenarioVariant variant) {
  for (const GameEvent& event : eventsOf(s, variant)) {
    if (event.clause == clause) return true;
  }
  return false;
}

void check(const Sweep& sweep, const std::vector<int>& steps) {
  for (const int k : steps) {
    for (const bool sides : {false, true}) {
      for (const bool colours : {false, true}) {
        INFO("step " << k << " sides " << sides << " colours " << colours);
        CHECK(calls(sweep.at(k), sweep.clause, {sides, colours}) == (k >= 0));
      }
    }
  }
}
/// The threshold itself is not swept in space: which side it falls on is rounding.
void checkMillimetres(const Sweep& sweep) { check(sweep, {-3, -2, -1, 1, 2, 3}); }
void checkTicks(const Sweep& sweep) { check(sweep, {-3, -2, -1, 0, 1, 2, 3}); }

/// Two attackers in the area from the start but for the second, which jumps to `place`; then it plays the
/// ball.
Scenario secondAttackerAt(Vec2 place, double heading = 0.0) {
  Scenario s = scene({0.66, 0.30}, 1.5);
  robot(s, kBlue1).pose.position = {0.65, 0.20};
  s.moves = {jump(0.7, kBlue2, place, heading)};
  s.contacts = {{1.0, 1.0, kBlue2, {}, 0.01}};
  return s;
}

Scenario secondDefenderAt(Vec2 place, double heading = 0.0) {
  Scenario s = scene({0.66, 0.30}, 2.5);
  s.moves = {jump(0.7, kYellow1, place, heading)};
  s.contacts = {{1.0, 1.0, kYellow1, {}, 0.01}};
  return s;
}

/// Where, going out from the goal along y, the robot with this heading is half in the 3v3 area.
double halfwayIn(double y, double heading) {
  const FieldGeometry field;
  double in = 0.60, out = 0.50;
  for (int i = 0; i < 60; ++i) {
    const double x = (in + out) / 2;
    const AreaBody body = intoGoalFrame(field, Side::kRight, RobotModel{}, {{x, y}, heading});
    (shareInside(goalAreaOf(field), body) > 0.5 ? in : out) = x;
  }
  return in;
}

Scenario chargeFor(double ticks) {
  Scenario s = scene({0.20, 0.30}, 2.0);
  robot(s, kBlue1).pose.position = {0.63, -0.05};
  s.contacts = {{1.0, 1.0 + (ticks - 1) * kTick, kBlue1, kYellow0, 0.01}};
  return s;
}

Scenario pushFor(double ticks, Vec2 ball) {
  Scenario s = scene(ball, 2.0);
  s.rules.fouls.push = true;
  robot(s, kBlue1) = {kBlue1, {{-0.10, 0.40}, 0.0}, {0.3, 0.0}};
  robot(s, kYellow1) = {kYellow1, {{-0.02, 0.40}, 0.0}, {0.3, 0.0}};
  s.contacts = {{0.6, 0.6 + (ticks - 1) * kTick, kBlue1, kYellow1, 0.01}};
  return s;
}

Scenario keeperHoldsFor(double seconds) {
  Scenario s = scene({0.70 - kHalf - kRadius - 0.005, -0.05}, seconds + 1.0);
  s.moves = {jump(seconds, {}, {0.30, 0.30})};
  return s;
}

/// A robot presses the ball against the wall from 1 s on, for so many ticks.
Scenario pinnedFor(double ticks) {
  Scenario s = scene({-0.10, 0.65 - kRadius}, 6.0);
  s.rules.fouls.holding = true;
  robot(s, kBlue1).pose.position = {-0.10, 0.65 - 2 * kRadius - kHalf};
  const double until = 1.0 + (ticks - 1) * kTick;
  s.contacts = {{1.0, until, kBlue1, {}, 0.01}, {1.0, until, {}, {}, 0.01}};
  return s;
}

Scenario lyingUntil(Vec2 ball, double seconds) {
  Scenario s = scene(ball, seconds + 1.0);
  s.moves = {jump(seconds, {}, {-0.20, -0.10})};
  return s;
}

}  // namespace

TEST_CASE("the goal line, to the millimetre", "[scenarios]") {
  checkMillimetres(
      {clause::kGoal, [](double k) { return scene({0.75 + kRadius + k * kMillimetre, 0.1}, 0.1); }});
}

TEST_CASE("any part of an attacker in the area, to the millimetre", "[scenarios]") {
  const auto deg45 = 0.78539816339744831;
  checkMillimetres({clause::kAttackers,
                    [](double k) { return secondAttackerAt({0.60 - kHalf + k * kMillimetre, -0.30}); }});
  checkMillimetres({clause::kAttackers,
                    [](double k) { return secondAttackerAt({0.68, -0.35 - kHalf + k * kMillimetre}); }});
  checkMillimetres(
      {clause::kAttackers, [](double k) { return secondAttackerAt({0.55 - kHalf + k * kMillimetre, 0.0}); }});
  checkMillimetres({clause::kAttackers, [&](double k) {
                      return secondAttackerAt({0.55 - kHalf * std::sqrt(2.0) + k * kMillimetre, 0.0}, deg45);
                    }});
  checkMillimetres({clause::kAttackers, [&](double k) {
                      return secondAttackerAt({0.60 - kHalf * std::sqrt(2.0) + k * kMillimetre, 0.25}, deg45);
                    }});
}

TEST_CASE("half of a defender in the area, to the millimetre", "[scenarios]") {
  const auto deg30 = 0.52359877559829887;
  checkMillimetres(
      {clause::kDefenders, [](double k) { return secondDefenderAt({0.60 + k * kMillimetre, 0.25}); }});
  checkMillimetres(
      {clause::kDefenders, [](double k) { return secondDefenderAt({0.68, 0.35 - k * kMillimetre}); }});
  for (const double y : {0.0, 0.06, 0.10}) {
    const double x = halfwayIn(y, deg30);
    checkMillimetres(
        {clause::kDefenders, [&](double k) { return secondDefenderAt({x + k * kMillimetre, y}, deg30); }});
  }
}

TEST_CASE("the centre of a robot in the area, to the millimetre", "[scenarios]") {
  const Rules program = loadRules("league-program-2021").value();
  checkMillimetres({clause::kAttackers, [&](double k) {
                      Scenario s = secondAttackerAt({0.60 + k * kMillimetre, -0.30});
                      s.rules = program;
                      s.seconds = 4.0;
                      return s;
                    }});
}

TEST_CASE("the ball in the area, to the millimetre", "[scenarios]") {
  checkMillimetres({clause::kDefenders, [](double k) {
                      Scenario s = secondDefenderAt({0.65, 0.20});
                      s.ball = {0.60 + k * kMillimetre, 0.30};
                      return s;
                    }});
  checkMillimetres(
      {clause::kGoalKickStuck, [](double k) { return scene({0.55 + k * kMillimetre, 0.0}, 10.5); }});
}

TEST_CASE("who disputes a stuck ball, to the millimetre", "[scenarios]") {
  checkMillimetres({clause::kGoalKickStuck, [](double k) {
                      Scenario s = scene({0.67, 0.20}, 10.5);
                      s.rules.stuck.undisputed = UndisputedCall::kPenalty;  // so that it matters
                      robot(s, kYellow0).pose.position = {0.70, 0.12};
                      robot(s, kBlue1).pose.position = {0.67 - 0.1125 + k * kMillimetre, 0.20};
                      return s;
                    }});
}

TEST_CASE("the circle of a stuck ball, to the millimetre", "[scenarios]") {
  checkMillimetres({clause::kFreeBall, [](double k) {
                      Scenario s = scene({0.10, 0.20}, 10.5);
                      s.moves = {jump(5.0, {}, {0.20 - k * kMillimetre, 0.20})};
                      return s;
                    }});
}

TEST_CASE("the keeper's control of the ball, to the millimetre", "[scenarios]") {
  checkMillimetres({clause::kKeeperHolds, [](double k) {
                      return scene({0.70 - kHalf - kRadius - 0.010 + k * kMillimetre, -0.05}, 10.5);
                    }});
}

TEST_CASE("who disputes a pinned ball, to the millimetre", "[scenarios]") {
  checkMillimetres({clause::kFreeKickHolding, [](double k) {
                      Scenario s = pinnedFor(240);
                      robot(s, kYellow1).pose.position = {s.ball.x + 0.1125 + k * kMillimetre, s.ball.y};
                      return s;
                    }});
}

TEST_CASE("how much a pinned ball may move", "[scenarios]") {
  check({clause::kFreeKickHolding,
         [](double k) {
           Scenario s = pinnedFor(240);
           s.ball_velocity = {0.1 - 1e-3 * k, 0.0};
           return s;
         }},
        {-3, -2, -1, 1, 2, 3});
}

TEST_CASE("where a ball that was in and out of an area is stuck, to the tick", "[scenarios]") {
  // Of the 601 ticks of the count it is inside for at least half from the 301st on.
  checkTicks({clause::kGoalKickStuck, [](double k) {
                Scenario s = scene({0.67, 0.375}, 10.5);
                s.moves = {jump((301 - k) * kTick, {}, {0.67, 0.335})};
                return s;
              }});
}

TEST_CASE("how far from the ball a push is, to the millimetre", "[scenarios]") {
  checkMillimetres({clause::kPush, [](double k) {
                      Scenario s = pushFor(60, {});
                      // The pushed robot's centre, where it is when the push begins; the ball moves along.
                      s.ball = {-0.02, 0.40 + 0.15 + k * kMillimetre};
                      s.ball_velocity = {0.3, 0.0};
                      s.seconds = 1.3;
                      return s;
                    }});
}

TEST_CASE("for how long a ball is stuck, to the tick", "[scenarios]") {
  // The first tick of play counts as 0: the ball must lie there in 601 of them.
  checkTicks({clause::kFreeBall, [](double k) { return lyingUntil({0.10, 0.20}, 10.0 + (k + 2) * kTick); }});
  checkTicks(
      {clause::kGoalKickStuck, [](double k) { return lyingUntil({0.68, 0.20}, 10.0 + (k + 2) * kTick); }});
}

TEST_CASE("for how long the keeper holds the ball, to the tick", "[scenarios]") {
  checkTicks({clause::kKeeperHolds, [](double k) { return keeperHoldsFor(10.0 + (k + 2) * kTick); }});
}

TEST_CASE("for how long the keeper is charged, to the tick", "[scenarios]") {
  checkTicks({clause::kKeeperCharged, [](double k) { return chargeFor(12 + k); }});
}

TEST_CASE("for how long a robot is pushed, to the tick", "[scenarios]") {
  checkTicks({clause::kPush, [](double k) { return pushFor(30 + k, {0.0, -0.3}); }});
}

TEST_CASE("for how long a ball is pinned, to the tick", "[scenarios]") {
  checkTicks({clause::kFreeKickHolding, [](double k) { return pinnedFor(181 + k); }});
}

TEST_CASE("how recent a touch is taking part, to the tick", "[scenarios]") {
  checkTicks({clause::kAttackers, [](double k) {
                Scenario s = secondAttackerAt({0.65, -0.20});
                s.moves[0].at = 1.0;
                const double touch = 0.5 + k * kTick;
                s.contacts = {{touch, touch, kBlue2, {}, 0.01}};
                return s;
              }});
}

TEST_CASE("how long after the ball's touch a push is an excuse, to the tick", "[scenarios]") {
  checkTicks({clause::kAttackers, [](double k) {
                Scenario s = secondAttackerAt({0.65, -0.20});
                robot(s, kBlue2).pose.position = {0.50, -0.20};
                robot(s, kYellow1).pose.position = {0.40, -0.20};
                s.moves[0].at = 1.0;
                const double push = 1.0 - 0.5 - (k + 1) * kTick;  // one tick more than allowed at k = 0
                s.contacts = {{0.3, 1.2, kBlue2, {}, 0.01}, {push, push, kYellow1, kBlue2, 0.02}};
                s.seconds = 1.3;
                return s;
              }});
}

TEST_CASE("how long a penalty waits for a goal, to the tick", "[scenarios]") {
  checkTicks({clause::kDefenders, [](double k) {
                Scenario s = secondDefenderAt({0.65, 0.20});
                s.moves.push_back(jump(2.0 + (k + 1) * kTick, {}, {0.80, 0.1}));
                return s;
              }});
}

TEST_CASE("the cool-down after play began, to the tick", "[scenarios]") {
  checkTicks({clause::kAttackers, [](double k) {
                Scenario s = scene({0.66, 0.30}, 0.5 + k * kTick);
                robot(s, kBlue1).pose.position = {0.65, 0.20};
                robot(s, kBlue2).pose.position = {0.65, -0.20};
                s.contacts = {{0.1, 1.0, kBlue2, {}, 0.01}};
                return s;
              }});
}

TEST_CASE("the big area of 5v5, to the millimetre", "[scenarios]") {
  const auto crowd = [](TeamId team, Vec2 place) {
    Scenario s;
    s.rules = loadRules("vsss-5v5").value();
    s.ball = {0.80, -0.37};
    s.seconds = 2.5;
    const RobotId fifth{team, 4};
    s.robots = {{{other(team), 0}, {{0.0, 0.6}, 0.0}, {}},
                {{team, 1}, {{0.85, 0.30}, 0.0}, {}},
                {{team, 2}, {{0.85, 0.15}, 0.0}, {}},
                {{team, 3}, {{0.85, 0.0}, 0.0}, {}},
                {fifth, {{0.30, -0.30}, 0.0}, {}}};
    s.moves = {jump(0.7, fifth, place)};
    s.contacts = {{1.0, 1.0, fifth, {}, 0.01}};
    return s;
  };
  checkMillimetres({clause::kAttackers,
                    [&](double k) { return crowd(TeamId::kBlue, {0.75 - kHalf + k * kMillimetre, -0.2}); }});
  checkMillimetres(
      {clause::kDefenders, [&](double k) { return crowd(TeamId::kYellow, {0.75 + k * kMillimetre, -0.2}); }});
  checkMillimetres({clause::kDefenders,
                    [&](double k) { return crowd(TeamId::kYellow, {0.88, -0.40 + k * kMillimetre}); }});
}

TEST_CASE("for how long an excuse holds, to the tick", "[scenarios]") {
  checkTicks({clause::kAttackers, [](double k) {
                Scenario s = secondAttackerAt({0.65, -0.20});
                robot(s, kBlue2).pose.position = {0.50, -0.20};
                robot(s, kYellow1).pose.position = {0.40, -0.20};
                s.moves[0].at = 1.0;
                s.contacts = {{0.3, 5.0, kBlue2, {}, 0.01}, {0.8, 0.9, kYellow1, kBlue2, 0.02}};
                s.seconds = 4.0 + (k + 1) * kTick;
                return s;
              }});
}

TEST_CASE("how much push is an excuse", "[scenarios]") {
  // In steps of a thousandth of the impulse; less is no excuse.
  check({clause::kAttackers,
         [](double k) {
           Scenario s = secondAttackerAt({0.65, -0.20});
           robot(s, kBlue2).pose.position = {0.50, -0.0};
           robot(s, kYellow1).pose.position = {0.40, 0.0};  // so that all of the push is toward the goal
           s.moves[0].at = 1.0;
           s.contacts = {{0.3, 1.2, kBlue2, {}, 0.01}, {0.9, 0.9, kYellow1, kBlue2, 0.01 * (1 - 1e-3 * k)}};
           s.seconds = 1.3;
           return s;
         }},
        {-3, -2, -1, 1, 2, 3});
}

TEST_CASE("for how long a ball must move to be free, to the tick", "[scenarios]") {
  const Rules program = loadRules("league-program-2021").value();
  checkTicks({clause::kFreeBall, [&](double k) {
                Scenario s = scene({0.10, 0.20}, 5.5);
                s.rules = program;
                // It takes 6 ticks to end the count: one tick less is no end.
                ScenarioMove go = jump(2.0, {}, {0.10, 0.20}),
                             stop = jump(2.0 + (5 - k) * kTick, {}, {0.10, 0.20});
                go.velocity = Vec2{0.3, 0.0};
                stop.velocity = Vec2{};
                s.moves = {go, stop};
                return s;
              }});
}

TEST_CASE("how slow a stuck ball is by the program", "[scenarios]") {
  const Rules program = loadRules("league-program-2021").value();
  check({clause::kFreeBall,
         [&](double k) {
           Scenario s = scene({-0.30, 0.20}, 5.5);
           s.rules = program;
           s.ball_velocity = {0.1 - 1e-3 * k, 0.0};
           return s;
         }},
        {-3, -2, -1, 1, 2, 3});
}

TEST_CASE("how long the program waits, to the tick", "[scenarios]") {
  const Rules program = loadRules("league-program-2021").value();
  checkTicks({clause::kAttackers, [&](double k) {
                Scenario s = secondAttackerAt({0.65, -0.20});
                s.rules = program;
                s.moves[0].at = 1.0;
                s.seconds = 4.0 + k * kTick;
                return s;
              }});
}

TEST_CASE("how long a break of a charge may be, to the tick", "[scenarios]") {
  checkTicks({clause::kKeeperCharged, [](double k) {
                Scenario s = chargeFor(6);
                const double again = 1.0 + (9 - k) * kTick;  // three ticks off between the two at k = 0
                s.contacts.push_back({again, again + 5 * kTick, kBlue1, kYellow0, 0.01});
                return s;
              }});
}

TEST_CASE("how long the keeper may lose the ball, to the tick", "[scenarios]") {
  checkTicks({clause::kKeeperHolds, [](double k) {
                Scenario s = keeperHoldsFor(12.0);
                s.rules.stuck.area_seconds = 30.0;
                const Vec2 near = s.ball;
                s.moves = {jump(6.0, {}, {0.61, 0.20}), jump(6.0 + (30 - k) * kTick, {}, near)};
                s.seconds = 12.0;
                return s;
              }});
}

TEST_CASE("how old a scorer's touch may be, to the tick", "[scenarios]") {
  for (const int k : {-2, -1, 0, 1, 2}) {
    Scenario s = scene({0.30, 0.10}, 8.0);
    const double touch = 1.0 + k * kTick;
    s.contacts = {{touch, touch, kBlue2, {}, 0.01}};
    s.moves = {jump(6.0, {}, {0.80, 0.10})};
    const std::vector<GameEvent> events = eventsOf(s, {});
    REQUIRE(events.size() == 1);
    INFO(k);
    CHECK(events[0].robot.has_value() == (k >= 0));
  }
}

TEST_CASE("the length of a half, to the tick", "[scenarios]") {
  checkTicks({"half", [](double k) {
                Scenario s = scene({0.10, 0.20}, 2.0 + k * kTick);
                s.rules.half_seconds = 2.0;
                return s;
              }});
}

}  // namespace fulbito::test
