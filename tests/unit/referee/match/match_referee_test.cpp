#include "referee/match/match_referee.hpp"

#include "engine/core/math/random.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_stream.hpp"
#include "tests/unit/referee/referee_samples.hpp"

namespace fulbito {
namespace {

using testing::PaperMatch;
using testing::setupOf;

RefereeSetup shortMatch(TieBreak tie = TieBreak::kNone) {
  RefereeSetup setup = setupOf("vsss-3v3");
  setup.rules.half_seconds = 2.0;
  setup.rules.periods.first_kick_off = FirstKickOff::kBlue;
  setup.rules.periods.tie_break = tie;
  setup.rules.periods.overtime_seconds = 1.0;
  return setup;
}

void toShootOut(PaperMatch& match) {
  while (match.referee.state().period != kShootOutPeriod && !match.referee.state().ended) match.play(1.0);
  match.wander = false;
}

/// One kick: into the goal, or past the half-way line.
void kick(PaperMatch& match, bool hit) {
  const TeamId kicker = match.call.team;
  if (hit) {
    match.score(kicker);
  } else {
    match.ball.position.x = -0.1 * (match.call.ball.x < 0.0 ? -1.0 : 1.0);
    match.step();
  }
}

/// A match of `setup` at the first kick of its shoot-out.
PaperMatch atKick(const RefereeSetup& setup = shortMatch(TieBreak::kShootOut)) {
  PaperMatch match(setup);
  toShootOut(match);
  return match;
}

/// Whether the first kick goes on.
bool kickGoesOn(const PaperMatch& match) {
  return match.referee.state().shoot_out.taken == PerTeam<int>{0, 0};
}

/// The sign of the goal's x that is kicked at.
double towardGoal(const PaperMatch& match) { return match.call.ball.x < 0.0 ? -1.0 : 1.0; }

}  // namespace

TEST_CASE("two halves of exactly as many ticks as the profile says, the second begun by the other team",
          "[unit]") {
  PaperMatch match(shortMatch());
  CHECK(match.call.kind == RestartKind::kKickOff);
  CHECK(match.call.team == TeamId::kBlue);
  for (int i = 0; i < 119; ++i) {
    match.ball.position = {0.3 * (i % 2), 0.0};
    REQUIRE_FALSE(match.step());
  }
  CHECK(match.referee.remaining() == Approx(1.0 / 60));
  CHECK(match.step());
  CHECK(match.referee.state().period == 2);
  CHECK(match.call.team == TeamId::kYellow);
  CHECK(match.referee.state().blue_side == Side::kLeft);
  CHECK(match.count("half") == 1);
  match.play(10.0);
  CHECK(match.referee.state().ended);
  CHECK(match.tick == 240);
  CHECK(match.count("full-time") == 1);
  CHECK(match.count("kick-off") == 2);
  CHECK_FALSE(match.referee.state().winner);
}

TEST_CASE("sides change at half-time only where the profile says so", "[unit]") {
  RefereeSetup setup = shortMatch();
  setup.rules.periods.swap_sides = true;
  PaperMatch match(setup);
  match.play(10.0);
  CHECK(match.referee.state().blue_side == Side::kRight);
  for (const auto& pose : match.call.defaults.robots[indexOf(TeamId::kBlue)]) {
    if (pose) CHECK(pose->position.x > 0.0);
  }
}

TEST_CASE("the toss belongs to the seed and is fair", "[unit]") {
  RefereeSetup setup = shortMatch();
  setup.rules.periods.first_kick_off = FirstKickOff::kToss;
  int blue = 0;
  for (setup.seed = 0; setup.seed < 1000; ++setup.seed) {
    const TeamId first = MatchReferee(setup).open().team;
    CHECK(MatchReferee(setup).open().team == first);
    blue += first == TeamId::kBlue ? 1 : 0;
  }
  CHECK(blue > 440);
  CHECK(blue < 560);
}

TEST_CASE("a goal counts for the team that attacks that side and gives the other the kick-off", "[unit]") {
  PaperMatch match(shortMatch());
  match.score(TeamId::kYellow);
  CHECK(match.referee.state().score == PerTeam<int>{0, 1});
  CHECK(match.call.kind == RestartKind::kKickOff);
  CHECK(match.call.team == TeamId::kBlue);
  CHECK(match.count("goal") == 1);
}

TEST_CASE("a goal on the last tick counts", "[unit]") {
  PaperMatch match(shortMatch());
  for (int i = 0; i < 119; ++i) match.step();
  match.score(TeamId::kBlue);
  CHECK(match.referee.state().score[0] == 1);
  CHECK(match.referee.state().period == 2);
  for (int i = 0; i < 119; ++i) match.step();
  match.score(TeamId::kYellow);
  CHECK(match.referee.state().score[1] == 1);
  CHECK(match.referee.state().ended);
  CHECK(match.count("full-time") == 1);
}

TEST_CASE("the mercy rule ends the match at its lead, and is off by default", "[unit]") {
  RefereeSetup setup = shortMatch();
  for (const int goals : {0, 3}) {
    setup.rules.periods.mercy_goals = goals;
    PaperMatch match(setup);
    for (int i = 0; i < 3; ++i) match.score(TeamId::kBlue);
    CHECK(match.referee.state().ended == (goals == 3));
    CHECK(match.count("mercy") == (goals == 3 ? 1 : 0));
  }
}

TEST_CASE("golden goal: the first goal of the overtime ends the match", "[unit]") {
  for (const bool golden : {true, false}) {
    RefereeSetup setup = shortMatch(TieBreak::kOvertime);
    setup.rules.periods.golden_goal = golden;
    PaperMatch match(setup);
    while (match.referee.state().period != kOvertimePeriod) match.play(1.0);
    CHECK(match.count("overtime") == 1);
    match.score(TeamId::kYellow);
    CHECK(match.referee.state().ended == golden);
    match.play(5.0);
    CHECK(match.referee.state().ended);
    CHECK(match.referee.state().winner == TeamId::kYellow);
  }
}

TEST_CASE("overtime has as many parts as the profile says, begun in turn", "[unit]") {
  RefereeSetup setup = shortMatch(TieBreak::kOvertime);
  setup.rules.periods.overtime_parts = 2;
  PaperMatch match(setup);
  while (match.referee.state().period != kOvertimePeriod) match.play(1.0);
  const TeamId first = match.call.team;
  match.play(5.0);
  CHECK(match.referee.state().part == 2);
  CHECK(match.call.team == other(first));
  match.play(5.0);
  CHECK(match.referee.state().ended);
  CHECK_FALSE(match.referee.state().winner);
  CHECK(match.tick == 2 * 120 + 2 * 60);
}

TEST_CASE("a shoot-out by table: order of the kicks, early ends, sudden death", "[unit]") {
  struct Row {
    ShootOutOrder order;
    int kicks;
    std::string hits;            // of all kicks in order: x hit, - miss
    std::string order_of_kicks;  // f the first team, s the second
    char winner;
  };
  const std::vector<Row> rows = {
      {ShootOutOrder::kAlternating, 3, "x-x-", "fsfs", 'f'},
      {ShootOutOrder::kAlternating, 3, "x-xxxx-x", "fsfsf", 'f'},
      {ShootOutOrder::kAlternating, 3, "------x-", "fsfsfsfs", 'f'},
      {ShootOutOrder::kAlternating, 3, "xxxxxxxx-x", "fsfsfsfsfs", 's'},
      {ShootOutOrder::kSeries, 3, "xx-xx-x-", "fffsssfs", 'f'},
      {ShootOutOrder::kSeries, 3, "x--xx", "fffss", 's'},
      {ShootOutOrder::kAlternating, 1, "-x", "fs", 's'},
  };
  for (const Row& row : rows) {
    RefereeSetup setup = shortMatch(TieBreak::kShootOut);
    setup.rules.shoot_out.order = row.order;
    setup.rules.shoot_out.kicks = row.kicks;
    PaperMatch match(setup);
    toShootOut(match);
    const TeamId first = match.call.team;
    std::string order;
    for (std::size_t i = 0; !match.referee.state().ended && i < row.hits.size(); ++i) {
      CHECK(match.call.kind == RestartKind::kPenalty);
      CHECK(match.ids.size() == 2);
      order += match.call.team == first ? 'f' : 's';
      kick(match, row.hits[i] == 'x');
    }
    INFO(row.hits);
    CHECK(order == row.order_of_kicks);
    REQUIRE(match.referee.state().ended);
    CHECK(match.referee.state().winner == (row.winner == 'f' ? first : other(first)));
    CHECK(match.referee.state().score == PerTeam<int>{0, 0});
    CHECK(match.count("goal") == 0);
    CHECK(match.count("full-time") == 1);
  }
}

TEST_CASE("a shoot-out without end is tossed for", "[unit]") {
  RefereeSetup setup = shortMatch(TieBreak::kShootOut);
  setup.rules.shoot_out.max_kicks = 4;
  PaperMatch match(setup);
  toShootOut(match);
  int kicks = 0;
  for (; !match.referee.state().ended && kicks < 100; ++kicks) kick(match, false);
  CHECK(kicks == 8);
  CHECK(match.referee.state().winner);
}

TEST_CASE("a kick ends by time, rest, leaving the area, or midfield", "[unit]") {
  PaperMatch match = atKick();
  const double toward = towardGoal(match);
  SECTION("time") {
    for (int i = 0; i < 1799; ++i) match.step();
    CHECK(kickGoesOn(match));
    match.step();
    CHECK_FALSE(kickGoesOn(match));
  }
  SECTION("rest, but not before it was kicked") {
    for (int i = 0; i < 300; ++i) match.step();
    CHECK(kickGoesOn(match));
    match.ball.position.x += toward * 0.1;
    for (int i = 0; i < 59; ++i) match.step();
    CHECK(kickGoesOn(match));
    match.step();
    CHECK_FALSE(kickGoesOn(match));
  }
  SECTION("leaving the area backwards") {
    match.ball.velocity = {1.0, 0.0};
    match.ball.position.x = toward * 0.65;
    match.step();
    CHECK(kickGoesOn(match));
    match.ball.position = {toward * 0.56, 0.0};  // the arc is part of the area
    match.step();
    CHECK(kickGoesOn(match));
    match.ball.position.x = toward * 0.54;
    match.step();
    CHECK_FALSE(kickGoesOn(match));
  }
  SECTION("midfield") {
    match.ball.velocity = {1.0, 0.0};
    match.ball.position.x = toward * 0.01;
    match.step();
    CHECK(kickGoesOn(match));
    match.ball.position.x = toward * -0.01;
    match.step();
    CHECK_FALSE(kickGoesOn(match));
  }
}

TEST_CASE("a kick ends in the keeper's hold", "[unit]") {
  SECTION("the keeper holds the ball, alone and in its area, for half a second") {
    for (const bool by_the_book : {true, false}) {
      PaperMatch match = atKick();
      const double toward = towardGoal(match);
      RobotState& keeper = match.robots[match.ids[0].team == match.call.team ? 1 : 0];
      keeper.pose = {{toward * 0.70, 0.1}, 0.0};
      // A ball that hardly moves is not at rest: only the keeper's control can end the kick.
      match.ball.velocity = {0.1, 0.0};
      const Vec2 held{toward * (0.70 - 0.0375 - 0.0215 - (by_the_book ? 0.009 : 0.011)), 0.1};
      match.ball.position = held;
      for (int i = 0; i < 29; ++i) match.step();
      match.ball.position.x = toward * 0.62;  // lost for a tick: the count begins anew
      match.step();
      match.ball.position = held;
      for (int i = 0; i < 29; ++i) match.step();
      CHECK(kickGoesOn(match));
      match.step();
      CHECK(kickGoesOn(match) != by_the_book);
    }
  }
  SECTION("not while the kicker is there, nor outside the area, nor where the profile says so") {
    enum { kKickerNear, kOutside, kOff };
    for (const auto otherwise : {kKickerNear, kOutside, kOff}) {
      RefereeSetup changed = shortMatch(TieBreak::kShootOut);
      if (otherwise == kOff) changed.rules.shoot_out.held_seconds = 0.0;
      PaperMatch match = atKick(changed);
      const double toward = towardGoal(match);
      const bool keeper_first = match.ids[0].team != match.call.team;
      RobotState &keeper = match.robots[keeper_first ? 0 : 1], &kicker = match.robots[keeper_first ? 1 : 0];
      const double x = toward * (otherwise == kOutside ? 0.50 : 0.70);
      keeper.pose = {{x, 0.1}, 0.0};
      match.ball.position = {x - toward * 0.06, 0.1};
      match.ball.velocity = {0.1, 0.0};
      if (otherwise == kKickerNear) kicker.pose.position = match.ball.position - Vec2{toward * 0.11, 0.0};
      for (int i = 0; i < 100; ++i) match.step();
      CHECK(kickGoesOn(match));
    }
  }
}

TEST_CASE("walk-over: the present team plays for as long as the law says", "[unit]") {
  RefereeSetup setup = shortMatch();
  setup.present = {false, true};
  PaperMatch match(setup);
  CHECK(match.call.team == TeamId::kYellow);
  CHECK(match.ids.size() == 3);
  match.score(TeamId::kYellow);
  CHECK(match.call.team == TeamId::kYellow);
  match.score(TeamId::kYellow);
  match.play(1000.0);
  CHECK(match.referee.state().ended);
  CHECK(match.tick == 180 * 60);
  CHECK(match.referee.state().score == PerTeam<int>{-3, 2});
  CHECK(match.referee.state().winner == TeamId::kYellow);
  CHECK(match.count("walk-over") == 1);

  setup.rules.walk_over.mode = WalkOver::kForfeit;
  PaperMatch forfeit(setup);
  forfeit.step();
  CHECK(forfeit.referee.state().score == PerTeam<int>{-1, 0});

  setup.present = {false, false};
  PaperMatch nobody(setup);
  nobody.step();
  CHECK(nobody.referee.state().ended);
  CHECK(nobody.referee.state().score == PerTeam<int>{-3, -3});
  CHECK(nobody.count("walk-over") == 2);
  CHECK_FALSE(nobody.referee.state().winner);
}

TEST_CASE("restart delays hold the clock until the signal", "[unit]") {
  RefereeSetup setup = shortMatch();
  setup.rules.restart.delay = 0.5;
  setup.rules.restart.goal_delay = 1.0;
  PaperMatch match(setup);
  CHECK_FALSE(match.referee.state().playing);
  for (int i = 0; i < 30; ++i) match.step();
  CHECK(match.referee.state().playing);
  CHECK(match.referee.state().play_ticks == 0);
  match.step();
  CHECK(match.referee.state().play_ticks == 1);
  match.score(TeamId::kBlue);
  for (int i = 0; i < 59; ++i) match.step();
  CHECK_FALSE(match.referee.state().playing);
  match.step();
  CHECK(match.referee.state().playing);
  CHECK(match.count("false-start") == 0);
}

TEST_CASE("whatever happens, play restarts legally, one call a tick, and the match ends in time", "[unit]") {
  for (const std::string profile : {"vsss-3v3", "vsss-5v5", "league-program-2021", "training"}) {
    RefereeSetup setup = setupOf(profile);
    setup.rules.half_seconds = 60.0;
    setup.rules.periods.tie_break = TieBreak::kBoth;
    setup.rules.periods.overtime_seconds = 5.0;
    for (setup.seed = 1; setup.seed <= 5; ++setup.seed) {
      Rng rng(setup.seed, test::kTestStream);
      PaperMatch match(setup);
      match.wander = false;
      const double x = setup.field.length / 2, y = setup.field.width / 2;
      while (!match.referee.state().ended) {
        // The ball jumps now and then, seldom into a goal; robots jump too.
        if (rng.below(200) == 0) match.ball.position = {rng.uniform(-x, x), rng.uniform(-y, y)};
        if (rng.below(1500) == 0) match.score(kTeams[rng.below(2)]);
        for (RobotState& robot : match.robots) {
          if (rng.below(100) == 0) robot.pose.position = {rng.uniform(-x, x), rng.uniform(-y, y)};
        }
        if (match.referee.state().ended) break;
        const PerTeam<int> before = match.referee.state().score;
        const int goals = match.count("goal");
        const bool called = match.step();
        const PerTeam<int> after = match.referee.state().score;
        REQUIRE(after[0] + after[1] - before[0] - before[1] == match.count("goal") - goals);
        if (called && !match.referee.state().ended) {
          REQUIRE(legalPlacement(setup, match.referee.state(), match.call, match.referee.state().placed));
        }
        REQUIRE(match.tick < 60 * (2 * 60 + 2 * 5 + 40 * 31));
      }
      CHECK(match.count("full-time") == 1);
    }
  }
}

TEST_CASE("a copy of the referee goes on alike", "[unit]") {
  PaperMatch match(shortMatch(TieBreak::kBoth));
  match.play(1.0);
  PaperMatch copy = match;
  for (PaperMatch* m : {&match, &copy}) {
    for (int i = 0; i < 100 && !m->referee.state().ended; ++i) m->play(1.0);
  }
  CHECK(match.tick == copy.tick);
  REQUIRE(match.events.size() == copy.events.size());
  for (std::size_t i = 0; i < match.events.size(); ++i) {
    CHECK(match.events[i].clause == copy.events[i].clause);
    CHECK(match.events[i].tick == copy.events[i].tick);
  }
  CHECK(match.referee.state().winner == copy.referee.state().winner);
}

}  // namespace fulbito
