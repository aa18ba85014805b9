#include "fulbito/recorder.hpp"

#include "fulbito/recording.hpp"
#include "tests/support/catch.hpp"
#include "tests/support/scratch_folder.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {
namespace {

using namespace fulbito::test;

/// The true course of the match, to compare with the recording.
struct Witness final : MatchObserver {
  std::vector<std::uint64_t> hashes;
  std::vector<std::string> clauses;
  std::vector<Tick> plays;
  std::vector<WheelSpeeds> first_commands;

  void onPlayStart(const PlayStart& start) override { plays.push_back(start.tick); }
  void onTick(const MatchTick& tick) override {
    hashes.push_back(tick.hash);
    first_commands.push_back(tick.commands.front());
    for (const GameEvent& event : tick.events) clauses.emplace_back(event.clause);
  }
};

/// A recording of a match with its teams' drawings.
RecordingReader recordedWithDrawings(const MatchConfig& config, int per_second) {
  std::string bytes;
  auto match = Match::create(config);
  REQUIRE(match);
  auto recorder = MatchRecorder::create(into(bytes), config);
  REQUIRE(recorder);
  recorder->keepDrawings(per_second);
  match->watch(*recorder);
  while (match->step()) {
  }
  REQUIRE(recorder->written());
  return readerOf(bytes);
}

}  // namespace

TEST_CASE("a recorded match holds what happened", "[unit]") {
  const MatchConfig config = shortMatch("chaser", "chaser", 30.0);
  Witness witness;
  const std::string bytes = recorded(config, RecordingLevel::kFull, &witness);
  const auto reader = RecordingReader::parse(bytes, "match");
  REQUIRE(reader);
  CHECK(reader->finished());
  REQUIRE(reader->ticks() == static_cast<Tick>(witness.hashes.size()));
  CHECK(reader->result()->final_hash == witness.hashes.back());
  CHECK(reader->result()->complete);
  std::vector<std::string> clauses;
  std::vector<Tick> plays;
  for (std::size_t i = 0; i < reader->chunkCount(); ++i) {
    const auto chunk = reader->chunk(i);
    REQUIRE(chunk);
    for (const RecordedPlay& play : chunk->plays) plays.push_back(play.tick);
    for (const RecordedEvent& event : chunk->events) {
      if (event.clause != "placement") clauses.push_back(event.clause);
    }
    for (int row = 0; row < chunk->ticks; ++row) {
      const auto tick = static_cast<std::size_t>(chunk->first_tick + row);
      REQUIRE(chunk->tick_hashes[static_cast<std::size_t>(row)] ==
              static_cast<std::uint16_t>(witness.hashes[tick]));
      REQUIRE(chunk->commands[6 * static_cast<std::size_t>(row)].left == witness.first_commands[tick].left);
    }
  }
  CHECK(plays == witness.plays);
  CHECK(clauses == witness.clauses);
}

TEST_CASE("the recipe makes the same match again", "[unit]") {
  MatchConfig config = shortMatch("chaser", "chaser", 5.0);
  config.physics.substeps = 3;
  config.robot.robot.mass = 0.2;
  config.seed = 99;
  for (VisionModel& seat : config.vision) seat.position_noise = 0.002;
  const auto reader = RecordingReader::parse(recorded(config, RecordingLevel::kRecipe), "match");
  REQUIRE(reader);
  const RecordingRecipe& recipe = reader->header().recipe;
  MatchConfig again;
  again.teams = {*parseTeam(recipe.teams[0]), *parseTeam(recipe.teams[1])};
  again.rules = *parseRules(recipe.rules, "rules");
  again.physics = *parsePhysics(recipe.physics, "physics");
  again.robot = *parseRobot(recipe.robot, "robot");
  again.field = *parseField(recipe.field, "field");
  again.seed = recipe.seed;
  std::copy(recipe.vision.begin(), recipe.vision.end(), again.vision.begin());
  CHECK(hashOf(again) == reader->result()->final_hash);
}

TEST_CASE("the same match is the same file, at both levels, and who records changes no match", "[unit]") {
  const MatchConfig config = shortMatch("chaser", "chaser", 10.0);
  const std::string full = recorded(config, RecordingLevel::kFull);
  CHECK(full == recorded(config, RecordingLevel::kFull));
  const auto recipe = RecordingReader::parse(recorded(config, RecordingLevel::kRecipe), "recipe");
  REQUIRE(recipe);
  CHECK(recipe->sizeInBytes() < full.size());
  CHECK(recipe->result()->final_hash == hashOf(config));
}

TEST_CASE("a match that is stopped leaves a whole file", "[unit]") {
  const ScratchFolder folder;
  const std::string file = (folder.path() / "game.fbr").string();
  const MatchConfig config = shortMatch("chaser", "chaser", 60.0);
  auto match = Match::create(config);
  REQUIRE(match);
  auto recorder = MatchRecorder::create(file, config);
  REQUIRE(recorder);
  match->watch(*recorder);
  for (int tick = 0; tick < 1000; ++tick) match->step();
  match->finish();
  REQUIRE(recorder->written());
  const auto reader = RecordingReader::open(file);
  REQUIRE(reader);
  CHECK(reader->finished());
  CHECK(reader->ticks() == 1000);
  CHECK_FALSE(reader->result()->complete);
  CHECK(reader->result()->final_hash == match->hash());
}

TEST_CASE("what cannot be written is told before or after the match, never in it", "[unit]") {
  const MatchConfig config = shortMatch("chaser", "chaser", 20.0);
  CHECK(MatchRecorder::create("/nonexistent-folder/x.fbr", config).error().code == ErrorCode::kIo);
  int writes = 0;
  auto recorder = MatchRecorder::create(
      [&writes](std::string_view) -> Result<void> {
        if (++writes > 3) return fail(ErrorCode::kIo, "disk full");
        return {};
      },
      config);
  REQUIRE(recorder);
  auto match = Match::create(config);
  match->watch(*recorder);
  while (match->step()) {
  }
  CHECK(match->referee().ended);
  REQUIRE_FALSE(recorder->written());
  CHECK(recorder->written().error().message == "disk full");
}

TEST_CASE("teams' drawings are kept in the world's frame", "[unit]") {
  const TestEntry artist([](const Observation& seen) {
    TeamCommand command = allWheels({});
    if (!seen.wants_drawings) return command;
    command.drawings.push_back({DebugDrawing::Kind::kCircle, {0.25, -0.1}, {}, 0.05, "here"});
    return command;
  });
  MatchConfig config = shortMatch("chaser", "chaser", 1.0);
  config.teams[1] = artist.choice();
  config.rules.restart.delay = 0.0;
  const auto chunk = recordedWithDrawings(config, 20).chunk(0);
  REQUIRE(chunk);
  REQUIRE(chunk->drawings.size() == 40);  // two halves of a second
  const RecordedDrawing& drawing = chunk->drawings[7];
  CHECK(drawing.tick == 24);
  CHECK(drawing.team == TeamId::kYellow);
  CHECK(drawing.kind == RecordedDrawing::Kind::kCircle);
  CHECK(distance(drawing.from, {-0.25, 0.1}) < 1e-9);
  CHECK(drawing.text == "here");
  CHECK(readerOf(recorded(config)).chunk(0)->drawings.empty());
}

TEST_CASE("drawing changes nothing that is played", "[unit]") {
  for (const char* team : {"libero", "classic", "classic:navigator=bezier", "libero:navigator=univector"}) {
    INFO(team);
    MatchConfig config = shortMatch(team, "chaser", 5.0);
    for (VisionModel& seat : config.vision) seat.latency_ticks = 2;
    const RecordingReader plain = readerOf(recorded(config)), drawn = recordedWithDrawings(config, 60);
    REQUIRE(plain.result());
    REQUIRE(drawn.result());
    CHECK(drawn.result()->final_hash == plain.result()->final_hash);
    const auto chunk = drawn.chunk(0);
    REQUIRE(chunk);
    int lines = 0, names = 0;
    for (const RecordedDrawing& drawing : chunk->drawings) {
      CHECK(std::abs(drawing.from.x) < 1.5);
      CHECK(std::abs(drawing.from.y) < 1.5);
      if (drawing.kind == RecordedDrawing::Kind::kLine) ++lines;
      if (drawing.kind == RecordedDrawing::Kind::kText) ++names;
    }
    CHECK(lines > chunk->ticks);
    // libero says the reason of each move, too.
    const int texts = std::string_view(team).starts_with("libero") ? 2 : 1;
    CHECK(names == texts * 3 * chunk->ticks);
  }
}

}  // namespace fulbito
