#include "referee/match/false_start.hpp"

#include "referee/restarts/restart_call.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/referee/referee_samples.hpp"

namespace fulbito {
namespace {

using testing::PaperMatch;
using testing::setupOf;

RefereeSetup waiting() {
  RefereeSetup setup = setupOf("vsss-3v3");
  setup.rules.periods.first_kick_off = FirstKickOff::kBlue;
  setup.rules.restart.delay = 1.0;
  setup.rules.restart.hold_robots = false;
  return setup;
}

/// One of the team's robots leaves its place before the signal, for long enough that the referee sees it.
bool jump(PaperMatch& match, TeamId team, std::uint8_t number = 1) {
  for (std::size_t i = 0; i < match.ids.size(); ++i) {
    if (match.ids[i] == RobotId{team, number}) match.robots[i].pose.position.y += 0.05;
  }
  for (int i = 0; i < 10; ++i) {
    if (match.step()) return true;
  }
  return false;
}

/// Brings the match to a restart of this kind for blue.
PaperMatch at(RestartKind kind) {
  PaperMatch match(waiting());
  match.begin(
      makeCall(match.referee.setup(), match.referee.state(), {kind, TeamId::kBlue, {0.3, 0.3}, nullptr}));
  return match;
}

}  // namespace

TEST_CASE("a robot has moved when it is away far enough for long enough", "[unit]") {
  PaperMatch match(waiting());
  match.robots[1].pose.position.y += 0.021;
  for (int i = 0; i < 5; ++i) CHECK_FALSE(match.step());
  // Not yet clearly back: the count goes on.
  match.robots[1].pose.position.y -= 0.005;
  CHECK(match.step());
  CHECK(match.count("false-start") == 1);

  match.robots[1].pose.position.y += 0.021;
  for (int i = 0; i < 5; ++i) CHECK_FALSE(match.step());
  match.robots[1].pose.position.y -= 0.007;
  CHECK_FALSE(match.step());
  match.robots[1].pose.position.y += 0.007;
  for (int i = 0; i < 5; ++i) CHECK_FALSE(match.step());
}

TEST_CASE("moving on the signal is no false start, and held robots make none", "[unit]") {
  PaperMatch match(waiting());
  for (int i = 0; i < 60; ++i) match.step();
  CHECK(match.referee.state().playing);
  CHECK_FALSE(jump(match, TeamId::kBlue));
  CHECK(match.count("false-start") == 0);

  RefereeSetup held = waiting();
  held.rules.restart.hold_robots = true;
  PaperMatch quiet(held);
  CHECK_FALSE(jump(quiet, TeamId::kBlue));
}

TEST_CASE("law 9 by table: what the next false starts lead to", "[unit]") {
  struct Row {
    RestartKind kind;
    TeamId jumper;
    std::vector<RestartKind> kinds;
    std::vector<TeamId> teams;
  };
  constexpr auto kBlue = TeamId::kBlue, kYellow = TeamId::kYellow;
  constexpr auto kKick = RestartKind::kKickOff, kFree = RestartKind::kFreeKick;
  constexpr auto kBall = RestartKind::kFreeBall, kPen = RestartKind::kPenalty;
  // Blue takes each restart; the first false start is a warning and a repeat.
  const std::vector<Row> rows = {
      {kKick, kBlue, {kKick, kKick, kFree}, {kBlue, kYellow, kYellow}},
      {kKick, kYellow, {kKick, kKick, kFree}, {kBlue, kBlue, kBlue}},
      {kPen, kBlue, {kPen, kBall}, {kBlue, kBlue}},
      {kPen, kYellow, {kPen, kPen, kPen}, {kBlue, kBlue, kBlue}},
      {kFree, kBlue, {kFree, kFree}, {kBlue, kYellow}},
      {kFree, kYellow, {kFree, kPen}, {kBlue, kBlue}},
      {kBall, kBlue, {kBall, kFree}, {kBlue, kYellow}},
      {kBall, kYellow, {kBall, kFree}, {kBlue, kBlue}},
  };
  for (const Row& row : rows) {
    PaperMatch match = at(row.kind);
    for (std::size_t i = 0; i < row.kinds.size(); ++i) {
      INFO(nameOf(row.kind) << " " << nameOf(row.jumper) << " " << i);
      REQUIRE(jump(match, row.jumper));
      CHECK(match.call.kind == row.kinds[i]);
      CHECK(match.call.team == row.teams[i]);
      CHECK(match.count("false-start") == static_cast<int>(i) + 1);
    }
  }
}

TEST_CASE("defenders that move at a kick-off go back to their area", "[unit]") {
  PaperMatch match = at(RestartKind::kKickOff);
  jump(match, TeamId::kYellow);
  jump(match, TeamId::kYellow);
  CHECK(match.call.defenders_back);
  for (std::size_t i = 0; i < match.ids.size(); ++i) {
    if (match.ids[i].team == TeamId::kYellow) CHECK(match.robots[i].pose.position.x > 0.55);
  }
}

TEST_CASE("a keeper that moves at a penalty gets a card, then stays out for a while or until a goal",
          "[unit]") {
  PaperMatch match = at(RestartKind::kPenalty);
  const auto& keeper = match.referee.state().robots[indexOf(TeamId::kYellow)][0];
  jump(match, TeamId::kYellow, 0);
  CHECK(keeper.cards == 0);
  jump(match, TeamId::kYellow, 0);
  CHECK(keeper.cards == 1);
  CHECK_FALSE(keeper.out);
  jump(match, TeamId::kYellow, 0);
  CHECK(keeper.out);
  CHECK(match.ids.size() == 5);
  for (int i = 0; i < 60; ++i) match.step();
  SECTION("until a goal") {
    match.score(TeamId::kBlue);
    CHECK_FALSE(keeper.out);
    CHECK(match.ids.size() == 6);
  }
  SECTION("for 30 s of play") {
    while (match.referee.state().match_ticks < 30 * 60) match.play(1.0);
    CHECK(keeper.out);
    match.wander = false;
    while (match.count("free-ball") == 0) match.play(1.0);
    CHECK_FALSE(keeper.out);
    CHECK(match.ids.size() == 6);
  }
}

TEST_CASE("in a shoot-out a kicker that starts too soon again has lost its kick", "[unit]") {
  RefereeSetup setup = waiting();
  setup.rules.half_seconds = 1.0;
  setup.rules.periods.tie_break = TieBreak::kShootOut;
  PaperMatch match(setup);
  while (match.referee.state().period != kShootOutPeriod) match.play(1.0);
  const TeamId kicker = match.call.team;
  jump(match, kicker);
  CHECK(match.call.team == kicker);
  CHECK(match.referee.state().shoot_out.taken == PerTeam<int>{0, 0});
  jump(match, kicker);
  CHECK(match.referee.state().shoot_out.taken[indexOf(kicker)] == 1);
  CHECK(match.call.team == other(kicker));
  CHECK(match.referee.state().false_starts == PerTeam<int>{0, 0});
}

TEST_CASE("false starts without end do not halt the match", "[unit]") {
  RefereeSetup setup = waiting();
  setup.rules.restart.escalation = false;
  PaperMatch match(setup);
  for (int i = 0; i < 10; ++i) REQUIRE(jump(match, TeamId::kYellow));
  CHECK(match.referee.state().playing);
  CHECK_FALSE(jump(match, TeamId::kYellow));
  CHECK(match.count("false-start") == 10);
}

}  // namespace fulbito
