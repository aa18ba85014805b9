#include "match/check/answers.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

Observation seenAt(double ball_y) {
  Observation seen;
  seen.ball.position = {0.2, ball_y};
  for (std::size_t i = 0; i < 3; ++i) seen.own[i].present = true;
  return seen;
}

RecordedCalls toldAt(double ball_y) {
  RecordedCalls told;
  told.calls = {ReadyCall{seenAt(ball_y)}, DecideCall{seenAt(ball_y)}, DecideCall{seenAt(-ball_y)}};
  return told;
}

/// Turns to the ball's side.
TeamCommand toward(const Observation& seen) {
  return seen.ball.position.y > 0.0 ? allWheels({1.0, 2.0}) : allWheels({2.0, 1.0});
}

}  // namespace

TEST_CASE("a team that treats both sides equally answers mirrored calls with mirrored commands", "[unit]") {
  const TestEntry team(toward);
  const RecordedCalls told = toldAt(0.3);
  const auto plain = answersOf(team.choice(), told), image = answersOf(team.choice(), mirrored(told));
  REQUIRE(plain);
  REQUIRE(image);
  const AnswerDifference same = compareMirrored(told, *plain, *image);
  CHECK(same.compared == 2);
  CHECK(same.different == 0);
  // Without mirroring, both decisions differ.
  CHECK(compareAnswers(told, *plain, *image).different == 2);
}

TEST_CASE("the first difference names decision and robot, and robots off the field do not count", "[unit]") {
  const RecordedCalls told = toldAt(0.3);
  TeamAnswers a, b;
  a.commands = b.commands = {allWheels({1.0, 1.0}), allWheels({1.0, 1.0})};
  b.commands[1].robots[2].wheels.left = 1.0 + 1e-15;
  const AnswerDifference found = compareAnswers(told, a, b);
  CHECK(found.different == 1);
  CHECK(found.first == 1);
  CHECK(found.robot == 2);
  RecordedCalls away = told;
  std::get<DecideCall>(away.calls[2]).seen.own[2].present = false;
  CHECK(compareAnswers(away, a, b).different == 0);
}

TEST_CASE("placements are answers too", "[unit]") {
  TeamAnswers a, b;
  TeamPlacement poses;
  poses[1] = Pose2{{0.1, 0.2}, 0.0};
  a.places = {TeamProposal(poses)};
  poses[1]->position.y = 0.3;
  b.places = {TeamProposal(poses)};
  CHECK(compareAnswers({}, a, b).different == 1);
  CHECK(compareAnswers({}, a, a).different == 0);
  b.places = {std::nullopt};
  CHECK(compareAnswers({}, a, b).different == 1);
}

TEST_CASE("plays that begin with the ball on the long axis have no mirror image", "[unit]") {
  RecordedCalls told = toldAt(0.3);
  CHECK(offAxis(told).calls.size() == 3);
  PlacementRequest kick_off;
  told.calls.emplace_back(kick_off);
  told.calls.emplace_back(DecideCall{seenAt(0.3)});
  CHECK(offAxis(told).calls.size() == 3);
  CHECK(offAxis(toldAt(0.0)).calls.empty());
}

TEST_CASE("the other seat gets the same calls", "[unit]") {
  RecordedCalls told = toldAt(0.3);
  const RecordedCalls swapped = inOtherSeat(told);
  CHECK(swapped.info.team == TeamId::kYellow);
  CHECK(swapped.info.side == Side::kRight);
  CHECK(swapped.calls.size() == told.calls.size());
}

}  // namespace fulbito
