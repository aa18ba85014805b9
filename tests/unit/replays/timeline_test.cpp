#include <cmath>
#include <limits>

#include "fulbito/detail/math.hpp"
#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"
#include "tests/unit/replays/sample_recording.hpp"

namespace fulbito {
namespace {

/// A recording of a robot and a ball with 10 ticks per second and a sample every second tick. The robot moves
/// by 1 cm per tick, and turns through the angle at which headings wrap.
class Story {
 public:
  Story() {
    RecordingHeader header;
    header.control_rate = 10;
    header.sample_every = 2;
    header.chunk_ticks = 20;
    header.bodies = {{BodyKind::kRobot, RobotId{TeamId::kBlue, 0}}, {BodyKind::kBall, {}}};
    writer_.emplace(*RecordingWriter::create(
        [this](std::string_view bytes) -> Result<void> {
          bytes_.append(bytes);
          return {};
        },
        header));
  }

  void play(Tick delay, Tick play_ticks, PerTeam<int> score, bool robot = true) {
    RecordedPlay play;
    play.delay = delay;
    play.play_ticks = play_ticks;
    play.score = score;
    play.period = 2;
    play.blue_side = Side::kRight;
    play.starts.resize(2);
    robot_ = robot;
    at_ = {{1.0, 0.0}, 3.0};
    if (robot) play.starts[0] = {true, at_, {}, 0.0, {}};
    play.starts[1] = {true, {{0.5, 0.25}, 0.0}, {}, 0.0, {}};
    writer_->beginPlay(play);
  }
  void ticks(int count, bool playing) {
    for (int i = 0; i < count; ++i) {
      at_ = {at_.position + Vec2{0.01, 0.0}, math::wrapAngle(at_.heading + 0.1)};
      WorldState world;
      if (robot_) world.robots.push_back({at_, {}, 0.0, {}});
      world.balls.push_back({{0.5, 0.25}, {}, {}});
      const std::vector<WheelSpeeds> none(world.robots.size());
      writer_->add(RecordingTick{&world, none, 0, playing});
    }
  }
  void goal(TeamId team, std::optional<std::uint8_t> robot = {}) {
    RecordedEvent event;
    event.tick = writer_->tick();
    event.clause = "goal";
    event.team = team;
    event.robot = robot;
    writer_->add(event);
  }
  void draw() {
    RecordedDrawing drawing;
    drawing.tick = writer_->tick();
    drawing.text = "here";
    writer_->add(drawing);
  }
  ReplayTimeline read(const RecordingResult& result = {}) {
    REQUIRE(writer_->finish(result));
    const auto reader = RecordingReader::parse(bytes_, "story");
    REQUIRE(reader);
    auto timeline = ReplayTimeline::read(*reader);
    REQUIRE(timeline);
    return std::move(*timeline);
  }

 private:
  std::string bytes_;
  std::optional<RecordingWriter> writer_;
  bool robot_ = true;
  Pose2 at_;
};

}  // namespace

TEST_CASE("between samples a body is interpolated, its heading the short way", "[unit]") {
  Story story;
  story.play(0, 0, {0, 0});
  story.ticks(8, true);
  const ReplayTimeline timeline = story.read();
  CHECK(timeline.seconds() == 0.8);
  for (const double seconds : {0.0, 0.05, 0.1, 0.2, 0.25, 0.3, 0.71, 0.8}) {
    const ReplayMoment moment = timeline.at(seconds);
    INFO("at " << seconds);
    REQUIRE(moment.bodies.size() == 2);
    REQUIRE(moment.bodies[0]);
    CHECK(std::abs(moment.bodies[0]->position.x - (1.0 + 0.1 * seconds)) < 1e-4);
    CHECK(std::abs(math::wrapAngle(moment.bodies[0]->heading - (3.0 + seconds))) < 3.1e-3);
    CHECK(std::abs(moment.bodies[0]->heading) <= 3.1416);
    CHECK(moment.bodies[1]->position.x == 0.5);
  }
}

TEST_CASE("a play begins where it begins: nothing slides to its start", "[unit]") {
  Story story;
  story.play(0, 0, {0, 0});
  story.ticks(5, true);  // ends between two samples
  story.play(0, 5, {0, 0}, false);
  story.ticks(4, true);
  story.play(0, 9, {0, 0});
  story.ticks(4, true);
  const ReplayTimeline timeline = story.read();
  CHECK(std::abs(timeline.at(0.49).bodies[0]->position.x - 1.04) < 1e-4);  // the last sample is kept
  CHECK(timeline.at(0.49).play == 0);
  CHECK(timeline.at(0.5).play == 1);
  CHECK_FALSE(timeline.at(0.5).bodies[0]);
  CHECK_FALSE(timeline.at(0.89).bodies[0]);
  CHECK(timeline.at(0.9).bodies[0]->position.x == 1.0);
  CHECK(std::abs(timeline.at(0.95).bodies[0]->position.x - 1.01) < 6e-3);
  CHECK(timeline.at(0.9).play == 2);
  CHECK(timeline.at(0.9).period == 2);
  CHECK(timeline.at(0.9).blue_side == Side::kRight);
}

TEST_CASE("the clock stands while a restart waits and goes on after its signal", "[unit]") {
  Story story;
  story.play(4, 100, {0, 0});
  story.ticks(3, false);
  story.ticks(7, true);  // the signal comes at the fourth tick, which does not count
  story.play(2, 106, {0, 0});
  story.ticks(1, false);
  story.ticks(5, true);
  const ReplayTimeline timeline = story.read();
  CHECK_FALSE(timeline.at(0.0).playing);
  CHECK(timeline.at(0.0).play_seconds == 10.0);
  CHECK_FALSE(timeline.at(0.39).playing);
  CHECK(timeline.at(0.39).play_seconds == 10.0);
  CHECK(timeline.at(0.4).playing);
  CHECK(timeline.at(0.4).play_seconds == 10.0);
  CHECK(std::abs(timeline.at(0.45).play_seconds - 10.05) < 1e-9);
  CHECK(std::abs(timeline.at(0.99).play_seconds - 10.59) < 1e-9);
  CHECK(timeline.at(1.0).play_seconds == 10.6);
  CHECK_FALSE(timeline.at(1.1).playing);
  CHECK(timeline.at(1.2).play_seconds == 10.6);
  CHECK(std::abs(timeline.at(1.5).play_seconds - 10.9) < 1e-9);
}

TEST_CASE("a play that waits for no signal counts from its first tick", "[unit]") {
  Story story;
  SECTION("as the rule wants") { story.play(0, 0, {0, 0}); }
  SECTION("as it was repeated too often to wait") { story.play(5, 0, {0, 0}); }
  story.ticks(5, true);
  const ReplayTimeline timeline = story.read();
  CHECK(timeline.at(0.0).playing);
  CHECK(timeline.at(0.5).play_seconds == 0.5);
}

TEST_CASE("the score changes at the goal", "[unit]") {
  Story story;
  story.play(0, 0, {1, 2});
  story.ticks(10, true);
  story.goal(TeamId::kYellow, std::uint8_t{2});
  story.play(3, 10, {1, 3});
  story.ticks(6, true);
  story.goal(TeamId::kBlue);
  story.ticks(2, false);
  const ReplayTimeline timeline = story.read();
  CHECK(timeline.at(0.99).score == PerTeam<int>{1, 2});
  CHECK(timeline.at(1.0).score == PerTeam<int>{1, 3});
  CHECK(timeline.at(1.5).score == PerTeam<int>{1, 3});
  CHECK(timeline.at(1.6).score == PerTeam<int>{2, 3});
  const auto goals = timeline.goals();
  REQUIRE(goals.size() == 2);
  CHECK(goals[0].tick == 10);
  CHECK(goals[0].seconds == 1.0);
  CHECK(goals[0].team == TeamId::kYellow);
  CHECK(goals[0].robot == std::uint8_t{2});
  CHECK(goals[1].seconds == 1.6);
  CHECK_FALSE(goals[1].robot);
}

TEST_CASE("the end may change the score at the table", "[unit]") {
  Story story;
  story.play(0, 0, {0, 0});
  story.ticks(4, true);
  RecordingResult result;
  result.score = {3, 0};
  const ReplayTimeline timeline = story.read(result);
  CHECK(timeline.at(0.39).score == PerTeam<int>{0, 0});
  CHECK(timeline.at(0.4).score == PerTeam<int>{3, 0});
}

TEST_CASE("drawings are shown until newer ones, for a fifth of a second, in their play", "[unit]") {
  Story story;
  story.play(0, 0, {0, 0});
  story.ticks(4, true);
  story.draw();
  story.draw();
  story.ticks(2, true);
  story.draw();
  story.play(0, 6, {0, 0});
  story.ticks(2, true);
  const ReplayTimeline timeline = story.read();
  CHECK(timeline.drawingsAt(timeline.at(0.3)).empty());
  CHECK(timeline.drawingsAt(timeline.at(0.4)).size() == 2);
  CHECK(timeline.drawingsAt(timeline.at(0.59)).size() == 2);
  CHECK(timeline.drawingsAt(timeline.at(0.6)).empty());  // the next play has begun
  CHECK(timeline.drawingsAt(timeline.at(0.8)).empty());
}

TEST_CASE("a time out of range shows the nearest end", "[unit]") {
  const test::Told told = test::sample();
  const auto reader = RecordingReader::parse(told.bytes, "sample");
  REQUIRE(reader);
  const auto timeline = ReplayTimeline::read(*reader);
  REQUIRE(timeline);
  CHECK(timeline->ticks() == 70);
  CHECK(timeline->plays().size() == told.plays.size());
  CHECK(timeline->at(-1.0).tick == 0);
  CHECK(timeline->at(std::numeric_limits<double>::quiet_NaN()).tick == 0);
  CHECK(timeline->at(1e300).tick == 70);
  CHECK(timeline->at(7.0).seconds == 7.0);
  // The time of every tick leads back to that tick, despite rounding.
  for (Tick tick = 0; tick <= timeline->ticks(); ++tick) {
    REQUIRE(timeline->at(timeline->secondsAt(tick)).tick == tick);
  }
  ReplayMoment reused = timeline->at(2.5);  // one robot is missing at this time
  timeline->at(5.0, reused);
  CHECK(reused.bodies[1]);
}

TEST_CASE("what has no samples or no play cannot be shown", "[unit]") {
  const test::Told recipe = test::sample(70, true, test::sampleHeader(RecordingLevel::kRecipe));
  const auto a = ReplayTimeline::read(*RecordingReader::parse(recipe.bytes, "recipe"));
  REQUIRE_FALSE(a);
  CHECK(a.error().code == ErrorCode::kBadInput);
  CHECK(a.error().message.find("recipe") != std::string::npos);
  const test::Told none = test::sample(0, true);
  const auto b = ReplayTimeline::read(*RecordingReader::parse(none.bytes, "none"));
  REQUIRE_FALSE(b);
  CHECK(b.error().message.find("no play") != std::string::npos);
}

}  // namespace fulbito
