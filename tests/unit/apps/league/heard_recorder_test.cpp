#include "apps/league/heard_recorder.hpp"

#include <limits>

#include "replays/verify/cut.hpp"
#include "replays/verify/diff.hpp"
#include "replays/verify/repair.hpp"
#include "replays/verify/verify.hpp"
#include "tests/unit/apps/league/heard.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;
using wire::Foul;
using wire::Half;

constexpr double kStep = 1e-6;  // [m] and about [rad / 6]

}  // namespace

TEST_CASE("a frame that was heard is a tick, with places to a micrometre", "[unit]") {
  HeardMatch match;
  match.see(16, 16 * 100);
  const ReplayTimeline timeline = timelineOf(match.finish());
  CHECK(timeline.header().heard);
  CHECK(timeline.ticks() == 100);
  CHECK(timeline.plays().size() == 1);
  CHECK(timeline.events().empty());
  for (const RecordedSample& sample : timeline.samples()) {
    const wire::Vision vision = visionAt(static_cast<std::uint32_t>(sample.tick) * 16);
    for (std::size_t i = 0; i < 6; ++i) {
      const Pose2& sent = vision.robots[i / 3][i % 3].state.pose;
      CHECK(distance(sample.poses[i].position, sent.position) < kStep);
      CHECK(sample.poses[i].heading == Approx(sent.heading).margin(1e-5));
    }
    CHECK(distance(sample.poses[6].position, vision.ball.position) < kStep);
  }
}

TEST_CASE("robots that vision lacks are absent, and one that it has twice counts once", "[unit]") {
  HeardMatch match;
  match.see(16, 160);
  wire::Vision vision = visionAt(176);
  vision.robots[1].erase(vision.robots[1].begin() + 1);
  vision.robots[0].push_back(vision.robots[0].front());
  vision.robots[0].back().state.pose.position.x = 0.5;
  std::swap(vision.robots[1].front(), vision.robots[1].back());
  vision.robots[1].push_back({7, {}});
  CHECK(match.see(vision));
  match.see(192, 320);
  CHECK(match.recorder.counts().unknown == 1);
  const ReplayTimeline timeline = timelineOf(match.finish());
  REQUIRE(timeline.plays().size() == 3);
  CHECK(timeline.plays()[1].tick == 10);
  CHECK(timeline.plays()[1].kind == RestartKind::kGiven);
  CHECK_FALSE(timeline.plays()[1].starts[4].present);
  CHECK(timeline.plays()[2].starts[4].present);
  CHECK(distance(timeline.samples()[10].poses[3].position, visionAt(176).robots[1][0].state.pose.position) <
        kStep);
  CHECK(distance(timeline.samples()[10].poses[0].position, visionAt(176).robots[0][0].state.pose.position) <
        kStep);
}

TEST_CASE("frames that were lost are marked, and bodies move straight on", "[unit]") {
  HeardMatch match;
  match.see(16, 160);
  match.see(160, 160);          // twice
  match.see(16 * 14, 16 * 20);  // 11, 12 and 13 are missing
  match.see(16 * 12, 16 * 12);  // too late
  const HeardCounts& counts = match.recorder.counts();
  CHECK(counts.frames == 17);
  CHECK(counts.gaps == 1);
  CHECK(counts.lost == 3);
  CHECK(counts.late == 2);
  const RecordingReader reader = match.finish();
  const ReplayTimeline timeline = timelineOf(reader);
  CHECK(timeline.ticks() == 20);
  REQUIRE(timeline.events().size() == 1);
  CHECK(timeline.events()[0].clause == kVisionLost);
  CHECK(timeline.events()[0].tick == 14);
  CHECK(timeline.events()[0].value == 3.0);
  CHECK(distance(timeline.samples()[11].poses[6].position, visionAt(16 * 12).ball.position) < 2 * kStep);
  const auto& figures = reader.result()->figures;
  CHECK(std::find(figures.begin(), figures.end(), std::pair<std::string, double>("lost", 3.0)) !=
        figures.end());
}

TEST_CASE("commands of the referee make plays, clock and periods", "[unit]") {
  HeardMatch match;
  auto kick_off = command(Foul::kKickOff);
  kick_off.team = TeamId::kYellow;
  match.recorder.take(kick_off);
  match.see(16, 160);
  match.recorder.take(kick_off);  // repeated
  match.recorder.take(command(Foul::kStop));
  match.see(176, 320);
  match.recorder.take(command(Foul::kGameOn));
  match.see(336, 16 * 80);
  auto free_ball = command(Foul::kFreeBall);
  free_ball.quadrant = 3;
  match.recorder.take(free_ball);
  match.see(16 * 81, 16 * 90);
  match.recorder.take(command(Foul::kStop));
  match.see(16 * 91, 16 * 100);
  match.recorder.take(command(Foul::kKickOff, Half::kSecond));
  match.recorder.take(command(Foul::kGameOn, Half::kSecond));  // whose STOP was lost
  match.see(16 * 101, 16 * 120);
  CHECK_FALSE(match.recorder.halted());
  match.recorder.take(command(Foul::kHalt, Half::kNone));
  CHECK(match.recorder.halted());
  CHECK(match.recorder.counts().commands == 8);
  const RecordingReader reader = match.finish();
  CHECK(reader.result()->complete);
  CHECK(reader.result()->outcome == "draw");
  const ReplayTimeline timeline = timelineOf(reader);
  CHECK(clausesOf(timeline) == std::vector<std::string>{"referee.kick-off", "referee.stop", "referee.game-on",
                                                        "referee.free-ball", "referee.stop", "half",
                                                        "referee.kick-off", "referee.game-on",
                                                        "referee.halt"});
  CHECK(timeline.events()[3].value == 3.0);
  REQUIRE(timeline.plays().size() == 4);
  CHECK(timeline.plays()[0].kind == RestartKind::kGiven);
  CHECK(timeline.plays()[1].kind == RestartKind::kKickOff);
  CHECK(timeline.plays()[1].team == TeamId::kYellow);
  CHECK(timeline.plays()[1].tick == 10);
  CHECK(timeline.plays()[2].kind == RestartKind::kFreeBall);
  CHECK(timeline.plays()[2].play_ticks == 60);
  CHECK(timeline.plays()[3].period == 2);
  CHECK(timeline.plays()[3].play_ticks == 0);
  CHECK_FALSE(timeline.at(15.0 / 60).playing);
  CHECK(timeline.at(50.0 / 60).playing);
  CHECK_FALSE(timeline.at(85.0 / 60).playing);
  CHECK(timeline.at(110.0 / 60).period == 2);
}

TEST_CASE("a recorder that comes late knows the clock from the referee", "[unit]") {
  HeardMatch match;
  match.see(16, 160);
  auto on = command(Foul::kGameOn, Half::kSecond);
  on.seconds = 100.0;
  match.recorder.take(on);
  match.see(176, 16 * 70);
  auto stop = command(Foul::kFreeKick, Half::kSecond);
  match.recorder.take(stop);
  match.recorder.take(command(Foul::kStop, Half::kSecond));
  match.see(16 * 71, 16 * 71);
  const ReplayTimeline timeline = timelineOf(match.finish());
  CHECK(timeline.plays()[1].play_ticks == 6060);
  CHECK(timeline.plays()[1].period == 2);
}

TEST_CASE("the score is that of vision", "[unit]") {
  HeardMatch match;
  const auto with = [](std::uint32_t step, std::uint32_t blue, std::uint32_t yellow) {
    wire::Vision vision = visionAt(step);
    vision.goals = {blue, yellow};
    return vision;
  };
  CHECK(match.see(with(16, 4, 2)));
  CHECK(match.see(with(32, 4, 3)));
  CHECK(match.see(with(48, 5, 3)));
  CHECK(match.see(with(64, 0, ~0U)));  // no goal, but another count
  CHECK(match.see(with(80, 0, 0)));
  const ReplayTimeline timeline = timelineOf(match.finish());
  CHECK(clausesOf(timeline) == std::vector<std::string>{"goal", "goal"});
  CHECK(timeline.at(1.0 / 60).score == PerTeam<int>{4, 2});
  CHECK(timeline.at(2.0 / 60).score == PerTeam<int>{4, 3});
  CHECK(timeline.plays()[1].score == PerTeam<int>{0, 1'000'000});
  CHECK(timeline.at(5.0 / 60).score == PerTeam<int>{0, 0});
}

TEST_CASE("only one server counts, and one that begins anew ends the recording", "[unit]") {
  HeardMatch match;
  CHECK(match.see(visionAt(16 * 1000), 1, 0.0));
  CHECK(match.see(visionAt(16), 2, 0.5));
  CHECK(match.recorder.counts().strangers == 1);
  CHECK(match.see(visionAt(16 * 1001), 1, 0.6));
  CHECK_FALSE(match.see(visionAt(16), 2, 2.0));  // the first one is gone
  CHECK_FALSE(match.see(visionAt(16), 1, 0.7));  // far back
  wire::Vision later = visionAt(16);
  later.step = 4'000'000'000U;
  CHECK_FALSE(match.see(later, 1, 0.7));
  CHECK(match.finish().ticks() == 2);
}

TEST_CASE("impossible frames are left out", "[unit]") {
  HeardMatch match;
  match.see(16, 160);
  wire::Vision far = visionAt(176), nan = visionAt(192);
  far.ball.position.x = 1e9;
  nan.robots[1][2].state.pose.heading = std::numeric_limits<double>::quiet_NaN();
  CHECK(match.see(far));
  CHECK(match.see(nan));
  match.see(208, 320);
  CHECK(match.recorder.counts().odd == 2);
  CHECK(match.recorder.counts().lost == 2);
  CHECK(timelineOf(match.finish()).ticks() == 20);
}

TEST_CASE("a field that is not that of the rules is refused before a file is opened", "[unit]") {
  HeardMatch match;
  wire::Vision vision = visionAt(16);
  vision.field.length = 2.2;
  const auto seen = match.recorder.see(vision, kServer, 0.0);
  REQUIRE_FALSE(seen);
  CHECK(seen.error().code == ErrorCode::kUsage);
  CHECK(seen.error().message.find("2.20 x 1.30 m") != std::string::npos);
  CHECK(match.opened == 0);
}

TEST_CASE("a flood of commands and gaps leaves a recording that can be read", "[unit]") {
  HeardMatch match;
  for (std::uint32_t i = 0; i < 15'000; ++i) {
    match.recorder.take(command(Foul::kStop));
    match.recorder.take(command(Foul::kGameOn));
    CHECK(match.see(visionAt(32 * (i % 30 + 1) + 32 * 30 * (i / 30))));
  }
  CHECK(match.recorder.counts().commands == 30'000);
  const ReplayTimeline timeline = timelineOf(match.finish());
  CHECK(timeline.events().size() == 19'000);
}

TEST_CASE("what was heard is not simulated again, but cut, repaired and compared", "[unit]") {
  HeardMatch match;
  match.see(16, 16 * 400);
  match.recorder.take(command(Foul::kKickOff));
  match.recorder.take(command(Foul::kStop));
  match.see(16 * 401, 16 * 900);
  const std::string grown = match.bytes;
  const RecordingReader whole = match.finish();
  const auto verified = verify(whole);
  REQUIRE(verified);
  CHECK(verified->heard);
  CHECK(verified->finished);

  const auto bytes = cutPlays(whole, {1, 1});
  REQUIRE(bytes);
  const RecordingReader cut = readerOf(*bytes);
  CHECK(cut.header().heard);
  CHECK(cut.ticks() == 500);
  CHECK(timelineOf(cut).samples()[99].poses[6].position ==
        timelineOf(whole).samples()[499].poses[6].position);

  // As after a kill: the chunks of 6 s are there.
  const auto found = salvage(grown, "game.fbr");
  REQUIRE(found);
  const auto repaired = repair(*found);
  REQUIRE(repaired);
  const RecordingReader mended = readerOf(repaired->bytes);
  CHECK(mended.ticks() == 720);
  CHECK(timelineOf(mended).samples()[700].poses[0].position ==
        timelineOf(whole).samples()[700].poses[0].position);

  const auto found_difference = diff(whole, mended);
  REQUIRE(found_difference);
  CHECK_FALSE(found_difference->tick);
}

}  // namespace fulbito
