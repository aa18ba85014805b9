#include "apps/view/match_stage.hpp"

#include "tests/support/catch.hpp"
#include "tests/support/test_teams.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr double kTick = 1.0 / 60.0;

struct Shown {
  ReplayMoment moment;
  MatchOverlays overlays;
};

Shown shown(MatchStage& stage, const OverlayChoice& choice = {}) {
  Shown s;
  stage.show(choice, s.moment, s.overlays);
  return s;
}

}  // namespace

TEST_CASE("a live match is played as time goes by, whatever the steps", "[unit]") {
  auto match = Match::create(shortMatch());
  REQUIRE(match);
  MatchStage stage(*match);
  CHECK(stage.seconds() == 0.0);
  for (int i = 0; i < 100; ++i) stage.forward(0.01);
  CHECK(stage.seconds() == Approx(1.0).margin(1e-6));
  CHECK(match->tick() == 60);
  stage.forward(0.5);
  CHECK(stage.seconds() == Approx(1.5).margin(1e-6));
  stage.stepOn();
  CHECK(stage.seconds() == Approx(match->seconds()));
  stage.seek(0.2);
  CHECK(stage.seconds() == Approx(match->seconds()));
  stage.forward(1e6);
  CHECK(stage.over());
  CHECK(match->referee().ended);
  CHECK_FALSE(stage.edited());
}

TEST_CASE("a match that keeps its own time goes on by one tick per picture at least, two at most", "[unit]") {
  auto match = Match::create(shortMatch());
  REQUIRE(match);
  MatchStage stage(*match, 1.0);
  stage.forward(0.001);
  CHECK(match->tick() == 1);
  stage.forward(kTick);
  CHECK(match->tick() == 2);
  stage.forward(0.1);
  CHECK(match->tick() == 4);
  MatchStage fast(*match, 4.0);
  fast.forward(kTick);
  CHECK(match->tick() == 8);
}

TEST_CASE("being looked at changes no match", "[unit]") {
  const MatchConfig config = shortMatch();
  auto match = Match::create(config);
  REQUIRE(match);
  MatchStage stage(*match);
  while (!stage.over()) {
    stage.forward(0.0123);
    shown(stage);
  }
  CHECK(match->hash() == hashOf(config));
}

TEST_CASE("between two ticks bodies are shown between their places", "[unit]") {
  auto match = Match::create(shortMatch());
  REQUIRE(match);
  MatchStage stage(*match);
  stage.forward(1.0);
  stage.stepOn();
  Pose2 before, after;
  for (int i = 0; i < 250 && !(distance(before.position, after.position) > 1e-3); ++i) {
    stage.stepOn();
    before = match->world().robots[1].pose;
    stage.forward(0.5 * kTick);
    after = match->world().robots[1].pose;
  }
  const Shown half = shown(stage);
  REQUIRE(distance(before.position, after.position) > 1e-3);
  CHECK(distance(half.moment.bodies[1]->position, (before.position + after.position) / 2) < 1e-9);
  CHECK_FALSE(half.overlays.trails.empty());
  CHECK(half.overlays.trails[0].points.size() > 1);
}

TEST_CASE("score, calls and clock are the referee's", "[unit]") {
  auto match = Match::create(shortMatch("libero", "idle", 20.0));
  REQUIRE(match);
  MatchStage stage(*match);
  bool goal = false;
  while (!stage.over()) {
    stage.stepOn();
    const Shown now = shown(stage);
    CHECK(now.moment.score == match->referee().score);
    CHECK(now.moment.blue_side == match->referee().blue_side);
    if (now.overlays.banner.title == "Goal!") goal = true;
  }
  REQUIRE(match->referee().score[0] > 0);
  CHECK(goal);
}

TEST_CASE("what is held is shown where it is dragged, and an edit shows at once", "[unit]") {
  auto match = Match::create(shortMatch("idle", "idle", 10.0));
  REQUIRE(match);
  MatchStage stage(*match);
  stage.forward(0.5);
  MatchEditor& editor = *stage.editor();
  REQUIRE(editor.grab(match->placement().ball, false));
  editor.drag({0.25, 0.4});
  CHECK(distance(shown(stage).moment.bodies.back()->position, {0.25, 0.4}) < 1e-6);
  REQUIRE(editor.drop());
  stage.refresh();
  CHECK(stage.edited());
  CHECK(distance(shown(stage).moment.bodies.back()->position, {0.25, 0.4}) < 1e-6);
  stage.forward(0.5);
  CHECK(match->edits() == 1);
  CHECK(stage.edited());
}

TEST_CASE("the teams' drawings are shown on request", "[unit]") {
  const TestEntry artist([](const Observation&) {
    TeamCommand command;
    command.drawings.push_back({DebugDrawing::Kind::kLine, {0.1, 0.2}, {0.3, 0.4}, 0.0, "here"});
    return command;
  });
  MatchConfig config = shortMatch();
  config.teams[1] = artist.choice();
  auto match = Match::create(config);
  REQUIRE(match);
  MatchStage stage(*match);
  stage.stepOn();
  OverlayChoice choice;
  const Shown with = shown(stage, choice);
  REQUIRE(with.overlays.drawings.size() == 1);
  CHECK(with.overlays.drawings[0].team == TeamId::kYellow);
  CHECK(with.overlays.drawings[0].from == Vec2{-0.1, -0.2});  // yellow's frame is rotated by 180 degrees
  choice.drawings = false;
  CHECK(shown(stage, choice).overlays.drawings.empty());
}

}  // namespace fulbito
