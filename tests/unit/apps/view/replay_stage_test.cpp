#include "apps/view/replay_stage.hpp"

#include "tests/unit/apps/view/test_stages.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

constexpr double kForever = 1e9;  // [s]

std::string shortRecording() { return recorded(shortMatch("chaser", "chaser", 20.0)); }

}  // namespace

TEST_CASE("a recording stops at its ends", "[unit]") {
  const auto stage = replayStage(shortRecording());
  CHECK(stage->seconds() == 0.0);
  CHECK_FALSE(stage->over());
  stage->seek(-3.0);
  CHECK(stage->seconds() == 0.0);
  stage->forward(1.5);
  CHECK(stage->seconds() == Approx(1.5));
  stage->stepOn();
  CHECK(stage->seconds() == Approx(1.5 + 1.0 / 60.0));
  stage->forward(kForever);
  CHECK(stage->over());
  CHECK(stage->seconds() == stage->look().seconds);
}

TEST_CASE("events are looked at from a second before them, in order and there and back", "[unit]") {
  const std::string bytes = shortRecording();
  const auto stage = replayStage(bytes);
  const ReplayTimeline timeline = timelineOf(bytes);
  std::vector<double> forth, back;
  for (auto at = stage->eventAfter(-1.0); at; at = stage->eventAfter(*at)) forth.push_back(*at);
  for (auto at = stage->eventBefore(kForever); at; at = stage->eventBefore(*at))
    back.insert(back.begin(), *at);
  REQUIRE(forth.size() > 1);
  CHECK(forth == back);
  for (const double at : forth) {
    const bool called =
        std::any_of(timeline.events().begin(), timeline.events().end(), [&](const RecordedEvent& e) {
          return std::abs(std::max(0.0, timeline.secondsAt(e.tick) - ReplayStage::kLead) - at) < 1e-9;
        });
    CHECK(called);
  }
}

TEST_CASE("what is shown is the recording's moment, with and without overlays", "[unit]") {
  const std::string bytes = shortRecording();
  const auto stage = replayStage(bytes);
  stage->seek(3.21);
  ReplayMoment moment;
  MatchOverlays overlays;
  stage->show({}, moment, overlays);
  const ReplayMoment expected = timelineOf(bytes).at(3.21);
  CHECK(moment.tick == expected.tick);
  CHECK(moment.bodies.back()->position == expected.bodies.back()->position);
  CHECK_FALSE(overlays.trails.empty());
  OverlayChoice bare;
  bare.trail_seconds = 0.0;
  stage->show(bare, moment, overlays);
  CHECK(overlays.trails.empty());
}

TEST_CASE("a recording says whether it was edited", "[unit]") {
  CHECK_FALSE(replayStage(shortRecording())->edited());
  std::string bytes;
  const MatchConfig config = shortMatch("chaser", "chaser", 10.0);
  auto match = Match::create(config);
  auto recorder = MatchRecorder::create(into(bytes), config);
  REQUIRE(match);
  REQUIRE(recorder);
  match->watch(*recorder);
  for (int i = 0; i < 20; ++i) REQUIRE(match->step());
  Placement wanted = match->placement();
  wanted.ball = {0.0, 0.5};
  REQUIRE(match->replace(wanted));
  for (int i = 0; i < 400; ++i) REQUIRE(match->step());
  // The recording is cut off: the chunk of the first six seconds is written, the result is not.
  CHECK(replayStage(bytes)->edited());
  match->finish();
  CHECK(replayStage(bytes)->edited());
}

}  // namespace fulbito
