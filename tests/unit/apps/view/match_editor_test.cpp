#include "apps/view/match_editor.hpp"

#include "fulbito/detail/math.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

Match idleMatch() {
  auto match = Match::create(shortMatch("idle", "idle", 10.0));
  REQUIRE(match);
  for (int i = 0; i < 5; ++i) REQUIRE(match->step());
  return std::move(*match);
}

const Pose2& robotOf(const Placement& placement, TeamId team, std::size_t number) {
  return *placement.robots[indexOf(team)][number];
}

}  // namespace

TEST_CASE("the ball goes where it is dragged, without a jump to the pointer", "[unit]") {
  Match match = idleMatch();
  MatchEditor editor(match);
  const Vec2 ball = match.placement().ball;
  REQUIRE(editor.grab(ball + Vec2{0.01, 0.0}, false));
  CHECK(editor.holding());
  editor.drag(ball + Vec2{0.01, 0.0} + Vec2{0.2, 0.3});
  CHECK(distance(editor.placement().ball, ball + Vec2{0.2, 0.3}) < 1e-9);
  CHECK(distance(match.placement().ball, ball) < 1e-9);
  CHECK(editor.drop());
  CHECK_FALSE(editor.holding());
  CHECK(distance(match.placement().ball, ball + Vec2{0.2, 0.3}) < 1e-6);
}

TEST_CASE("a click that moves nothing is no edit", "[unit]") {
  Match match = idleMatch();
  MatchEditor editor(match);
  CHECK_FALSE(editor.grab({0.3, 0.55}, false));
  CHECK_FALSE(editor.drop());
  REQUIRE(editor.grab(match.placement().ball, false));
  CHECK_FALSE(editor.drop());
  REQUIRE(match.step());
  CHECK(match.edits() == 0);
}

TEST_CASE("a robot is moved, and stays at the last free place where there is no room", "[unit]") {
  Match match = idleMatch();
  MatchEditor editor(match);
  const Vec2 from = robotOf(match.placement(), TeamId::kYellow, 1).position;
  REQUIRE(editor.grab(from, false));
  editor.drag({0.3, 0.5});
  CHECK(editor.flaw().empty());
  editor.drag({0.3, 5.0});
  CHECK(editor.flaw() == "yellow robot 1 would not be on the field");
  editor.drag(robotOf(match.placement(), TeamId::kBlue, 0).position);
  CHECK(editor.flaw() == "yellow robot 1 would overlap a robot");
  CHECK(robotOf(editor.placement(), TeamId::kYellow, 1).position == Vec2{0.3, 0.5});
  REQUIRE(editor.drop());
  CHECK(distance(robotOf(match.placement(), TeamId::kYellow, 1).position, {0.3, 0.5}) < 1e-6);
}

TEST_CASE("a robot's front is turned to the pointer, or by the wheel", "[unit]") {
  Match match = idleMatch();
  MatchEditor editor(match);
  const Pose2 before = robotOf(match.placement(), TeamId::kBlue, 2);
  REQUIRE(editor.grab(before.position, true));
  editor.drag(before.position + Vec2{0.0, 0.2});
  REQUIRE(editor.drop());
  const Pose2 after = robotOf(match.placement(), TeamId::kBlue, 2);
  CHECK(after.heading == Approx(math::kPi / 2));
  CHECK(distance(after.position, before.position) < 1e-6);
  REQUIRE(editor.turn(after.position, -0.25));
  CHECK(robotOf(match.placement(), TeamId::kBlue, 2).heading == Approx(math::kPi / 2 - 0.25));
  CHECK_FALSE(editor.turn({0.3, 0.55}, 0.25));
  // The ball has no front, so it cannot be turned.
  CHECK_FALSE(editor.grab(match.placement().ball, true));
}

TEST_CASE("nothing can be moved once the match is over", "[unit]") {
  Match match = idleMatch();
  MatchEditor editor(match);
  while (match.step()) {
  }
  CHECK_FALSE(editor.grab(match.placement().ball, false));
  CHECK_FALSE(editor.turn(robotOf(match.placement(), TeamId::kBlue, 2).position, 1.0));
}

}  // namespace fulbito
