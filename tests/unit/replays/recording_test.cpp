#include "fulbito/recording.hpp"

#include <cmath>

#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/unit/replays/sample_recording.hpp"

namespace fulbito {
namespace {

using test::sample;
using test::sampleHeader;
using test::Told;

constexpr double kPlaceStep = 5e-4;                  // [m]
constexpr double kHeadingStep = 6.283185307 / 1024;  // [rad]

/// The content of all chunks of a recording, joined.
RecordedChunk whole(const RecordingReader& reader) {
  RecordedChunk all;
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  for (std::size_t i = 0; i < reader.chunkCount(); ++i) {
    const auto chunk = reader.chunk(i);
    REQUIRE(chunk);
    REQUIRE(chunk->first_tick == all.ticks);
    REQUIRE(chunk->plays_before == static_cast<std::int64_t>(all.plays.size()));
    all.ticks += chunk->ticks;
    append(all.plays, chunk->plays);
    append(all.tick_hashes, chunk->tick_hashes);
    append(all.playing, chunk->playing);
    append(all.commands, chunk->commands);
    append(all.checks, chunk->checks);
    append(all.events, chunk->events);
    append(all.drawings, chunk->drawings);
    append(all.samples, chunk->samples);
  }
  return all;
}

bool sameBits(Vec2 a, Vec2 b) {
  return std::bit_cast<std::uint64_t>(a.x) == std::bit_cast<std::uint64_t>(b.x) &&
         std::bit_cast<std::uint64_t>(a.y) == std::bit_cast<std::uint64_t>(b.y);
}

void checkPlays(const std::vector<RecordedPlay>& read, const std::vector<RecordedPlay>& told) {
  REQUIRE(read.size() == told.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    CHECK(read[i].tick == told[i].tick);
    CHECK(read[i].kind == told[i].kind);
    CHECK(read[i].team == told[i].team);
    CHECK(sameBits(read[i].ball, told[i].ball));
    CHECK(read[i].delay == told[i].delay);
    CHECK(read[i].defenders_back == told[i].defenders_back);
    CHECK(read[i].period == told[i].period);
    CHECK(read[i].play_ticks == told[i].play_ticks);
    CHECK(read[i].score == told[i].score);
    CHECK(read[i].blue_side == told[i].blue_side);
    CHECK(read[i].hash == told[i].hash);
    for (std::size_t body = 0; body < told[i].starts.size(); ++body) {
      const RecordedStart &a = read[i].starts[body], &b = told[i].starts[body];
      REQUIRE(a.present == b.present);
      CHECK(sameBits(a.pose.position, b.pose.position));
      CHECK(a.pose.heading == b.pose.heading);
      CHECK(sameBits(a.velocity, b.velocity));
      CHECK(a.angular_velocity == b.angular_velocity);
      CHECK(sameBits(a.spin, b.spin));
    }
  }
}

void checkCommands(const RecordedChunk& read, const Told& told) {
  REQUIRE(read.ticks == static_cast<int>(told.commands.size()));
  for (std::size_t tick = 0; tick < told.commands.size(); ++tick) {
    for (std::size_t robot = 0; robot < 4; ++robot) {
      REQUIRE(read.commands[4 * tick + robot].left == told.commands[tick][robot].left);
      REQUIRE(read.commands[4 * tick + robot].right == told.commands[tick][robot].right);
    }
    REQUIRE(read.tick_hashes[tick] == static_cast<std::uint16_t>(told.hashes[tick]));
    REQUIRE((read.playing[tick] != 0) == told.playing[tick]);
  }
}

void checkSamples(const RecordedChunk& read, const Told& told) {
  REQUIRE(read.samples.size() == told.worlds.size() / 3);
  for (std::size_t i = 0; i < read.samples.size(); ++i) {
    const RecordedSample& sampled = read.samples[i];
    REQUIRE(sampled.tick == static_cast<Tick>(3 * (i + 1)));
    const WorldState& world = told.worlds[static_cast<std::size_t>(sampled.tick) - 1];
    const Pose2& last = sampled.poses[3];
    const Pose2& truth = world.robots.back().pose;
    CHECK(std::abs(last.position.x - truth.position.x) <= 0.501 * kPlaceStep);
    CHECK(std::abs(last.heading - truth.heading) <= 0.501 * kHeadingStep);
    CHECK(std::abs(sampled.poses[4].position.y - world.balls[0].position.y) <= 0.501 * kPlaceStep);
    CHECK(sampled.poses[4].heading == 0.0);
    CHECK(std::abs(sampled.poses[5].heading - world.obstacles[0].pose.heading) <= 0.501 * kHeadingStep);
  }
}

}  // namespace

TEST_CASE("a recording gives back what it was told", "[unit]") {
  const Told told = sample();
  const auto reader = RecordingReader::parse(told.bytes, "sample");
  REQUIRE(reader);
  CHECK(reader->finished());
  CHECK(reader->ticks() == 70);
  CHECK(reader->chunkCount() == 4);
  const RecordedChunk all = whole(*reader);
  checkPlays(all.plays, told.plays);
  checkCommands(all, told);
  checkSamples(all, told);
}

TEST_CASE("the header and the result come back whole", "[unit]") {
  const Told told = sample();
  const auto reader = RecordingReader::parse(told.bytes, "sample");
  REQUIRE(reader);
  const RecordingHeader& header = reader->header();
  CHECK(header.kind == RecordingKind::kMatch);
  CHECK(header.level == RecordingLevel::kFull);
  CHECK(header.bodies.size() == 6);
  CHECK(header.bodies[3].id == RobotId{TeamId::kYellow, 1});
  CHECK_FALSE(header.bodies[4].id);
  CHECK(header.recipe.rules == told.header.recipe.rules);
  CHECK(header.recipe.teams == told.header.recipe.teams);
  CHECK(header.recipe.seed == told.header.recipe.seed);
  CHECK(header.recipe.vision == told.header.recipe.vision);
  CHECK(header.recipe.more == told.header.recipe.more);
  CHECK(header.build.compiler == "gcc");
  REQUIRE(reader->result());
  CHECK(reader->result()->ticks == 70);
  CHECK(reader->result()->score == PerTeam<int>{3, 1});
  CHECK(reader->result()->final_hash == told.result.final_hash);
  CHECK(reader->result()->figures == told.result.figures);
}

TEST_CASE("events, drawings and checks come back", "[unit]") {
  const Told told = sample();
  const auto reader = RecordingReader::parse(told.bytes, "sample");
  REQUIRE(reader);
  const RecordedChunk all = whole(*reader);
  REQUIRE(all.events.size() == told.events.size());
  for (std::size_t i = 0; i < all.events.size(); ++i) {
    CHECK(all.events[i].tick == told.events[i].tick);
    CHECK(all.events[i].clause == told.events[i].clause);
    CHECK(all.events[i].law == told.events[i].law);
    CHECK(all.events[i].team == told.events[i].team);
    CHECK(all.events[i].robot == told.events[i].robot);
    CHECK(all.events[i].value == told.events[i].value);
    CHECK(all.events[i].threshold == 10.0);
    CHECK(all.events[i].margin == 0.0);
  }
  REQUIRE(all.drawings.size() == 8);
  CHECK(all.drawings[1].tick == 10);
  CHECK(all.drawings[1].text == "pass");
  CHECK(std::abs(all.drawings[1].from.x - 0.1234) < 1e-12);
  REQUIRE(all.checks.size() == 7);
  CHECK(all.checks[2].tick == 30);
  // Blue's second robot is absent from tick 23 to 46, so yellow's second robot is the world's third.
  CHECK(all.checks[2].bodies[1] == BodyHash{});
  CHECK(all.checks[2].bodies[3] == bodyHash(told.worlds[29], 2));
  CHECK(all.checks[2].bodies[4] == bodyHash(told.worlds[29], 3));
  CHECK(all.checks[2].bodies[5] == bodyHash(told.worlds[29], 4));
}

TEST_CASE("a sampled heading of half a turn to the left is that to the right", "[unit]") {
  Told told;
  told.header = sampleHeader();
  test::Teller teller(told);
  RecordedPlay play;
  play.starts.assign(6, {true, {}, {}, 0.0, {}});
  teller.writer().beginPlay(play);
  WorldState world;
  world.robots.resize(4);
  world.balls.resize(1);
  world.obstacles.resize(1);
  for (const double turns : {0.5, -0.5, 0.25}) {
    world.robots[0].pose.heading = turns * 1024 * kHeadingStep;
    for (int tick = 0; tick < 3; ++tick) teller.writer().add(RecordingTick{&world, {}, 0, true});
  }
  REQUIRE(teller.finish(9));
  const auto reader = RecordingReader::parse(told.bytes, "sample");
  REQUIRE(reader);
  const RecordedChunk all = whole(*reader);
  REQUIRE(all.samples.size() == 3);
  CHECK(all.samples[0].poses[0].heading == Approx(-512 * kHeadingStep));
  CHECK(all.samples[1].poses[0].heading == Approx(-512 * kHeadingStep));
  CHECK(all.samples[2].poses[0].heading == Approx(256 * kHeadingStep));
}

TEST_CASE("a recipe is a full recording without what can be computed again", "[unit]") {
  const Told full = sample(), recipe = sample(70, true, sampleHeader(RecordingLevel::kRecipe));
  CHECK(recipe.bytes.size() < full.bytes.size());
  const auto reader = RecordingReader::parse(recipe.bytes, "sample");
  REQUIRE(reader);
  const RecordedChunk all = whole(*reader);
  CHECK(all.samples.empty());
  CHECK(all.drawings.empty());
  checkCommands(all, recipe);
  checkPlays(all.plays, recipe.plays);
}

TEST_CASE("commands that are not rounded are kept to the last bit", "[unit]") {
  RecordingHeader header = sampleHeader();
  header.command_step = 0.0;
  const Told told = sample(70, true, header);
  const auto reader = RecordingReader::parse(told.bytes, "sample");
  REQUIRE(reader);
  const RecordedChunk all = whole(*reader);
  checkCommands(all, told);
  CHECK(std::signbit(all.commands[1].right) == std::signbit(told.commands[0][1].right));
}

TEST_CASE("the same is written to the same bytes", "[unit]") { CHECK(sample().bytes == sample().bytes); }

TEST_CASE("a file holds the bytes, and grows while it is written", "[unit]") {
  const test::ScratchFolder folder;
  const std::string file = (folder.path() / "game.fbr").string();
  const Told told = sample();
  auto writer = RecordingWriter::create(file, told.header);
  REQUIRE(writer);
  RecordedPlay play;
  play.starts.resize(6);
  writer->beginPlay(play);
  const WorldState nobody;
  for (int tick = 0; tick < 41; ++tick) writer->add(RecordingTick{&nobody, {}, 0, true});
  const auto cut = RecordingReader::open(file);
  REQUIRE(cut);
  CHECK_FALSE(cut->finished());
  CHECK(cut->ticks() == 40);
  REQUIRE(writer->finish({}));
  const auto complete = RecordingReader::open(file);
  REQUIRE(complete);
  CHECK(complete->finished());
  CHECK(complete->ticks() == 41);
}

TEST_CASE("what cannot be written or read is an error that says so", "[unit]") {
  const test::ScratchFolder folder;
  const auto nowhere = RecordingWriter::create("/nonexistent-folder/x.fbr", sampleHeader());
  REQUIRE_FALSE(nowhere);
  CHECK(nowhere.error().code == ErrorCode::kIo);
  CHECK(nowhere.error().message.find("/nonexistent-folder/x.fbr") != std::string::npos);
  RecordingHeader impossible = sampleHeader();
  impossible.sample_turn = 0;
  CHECK(RecordingWriter::create((folder.path() / "x.fbr").string(), impossible).error().message ==
        "cannot record this: sample_turn is outside 1 ... 1000000");
  impossible.control_rate = 0;
  CHECK(RecordingWriter::create((folder.path() / "x.fbr").string(), impossible).error().code ==
        ErrorCode::kUsage);
  CHECK(RecordingReader::open(folder.path().string()).error().code == ErrorCode::kIo);
  CHECK(RecordingReader::open((folder.path() / "none.fbr").string()).error().code == ErrorCode::kIo);
}

TEST_CASE("a full disk is told at the end, not in the middle of a match", "[unit]") {
  std::size_t left = 3000;
  auto writer = RecordingWriter::create(
      [&left](std::string_view bytes) -> Result<void> {
        if (bytes.size() > left) return fail(ErrorCode::kIo, "disk full");
        left -= bytes.size();
        return {};
      },
      sampleHeader());
  REQUIRE(writer);
  RecordedPlay play;
  play.starts.resize(6);
  for (int second = 0; second < 2000; ++second) {
    writer->beginPlay(play);
    const WorldState nobody;
    writer->add(RecordingTick{&nobody, {}, 0x123456789abcdefu * static_cast<unsigned>(second), true});
  }
  const auto finished = writer->finish({});
  REQUIRE_FALSE(finished);
  CHECK(finished.error().message == "disk full");
  CHECK(left < 3000);
}

}  // namespace fulbito
