#include "replays/verify/expand.hpp"

#include "replays/verify/verify.hpp"
#include "tests/support/test_recordings.hpp"

namespace fulbito {

using namespace fulbito::test;

TEST_CASE("an expanded recipe is the full recording, byte for byte", "[unit]") {
  const MatchConfig config = shortMatch("chaser", "chaser", 30.0);
  const RecordingReader recipe = readerOf(recorded(config, RecordingLevel::kRecipe));
  const auto full = expanded(recipe);
  REQUIRE(full);
  CHECK(full->header().level == RecordingLevel::kFull);
  CHECK(full->bytes() == recorded(config, RecordingLevel::kFull));
  CHECK(full->origin() == "game.fbr");
  const auto again = expanded(*full);
  REQUIRE(again);
  CHECK(again->bytes() == full->bytes());
}

TEST_CASE("a cut recipe is expanded as far as it goes", "[unit]") {
  std::string bytes = recorded(shortMatch("chaser", "chaser", 20.0), RecordingLevel::kRecipe);
  bytes.resize(3 * bytes.size() / 4);
  const RecordingReader cut = readerOf(bytes);
  REQUIRE_FALSE(cut.finished());
  REQUIRE(cut.ticks() > 0);
  const auto full = expanded(cut);
  REQUIRE(full);
  CHECK(full->ticks() == cut.ticks());
  CHECK_FALSE(full->result()->complete);
  CHECK(verify(*full)->same());
}

TEST_CASE("a recipe that does not come out the same is not expanded", "[unit]") {
  const MatchConfig config = shortMatch("chaser", "chaser", 10.0);
  const RecordingReader recipe = readerOf(recorded(config, RecordingLevel::kRecipe));
  // The same commands in a world with slightly less grip.
  RecordingHeader header = recipe.header();
  PhysicsProfile physics = config.physics;
  physics.substeps += 1;
  header.recipe.physics = toToml(physics);
  std::string bytes;
  auto writer = RecordingWriter::create(into(bytes), header);
  REQUIRE(writer);
  const auto chunk = recipe.chunk(0);
  REQUIRE(chunk);
  writer->beginPlay(chunk->plays.front());
  WorldState world;
  world.robots.resize(6);
  world.balls.resize(1);
  for (std::size_t row = 0; row < 100; ++row) {
    const std::span commands(chunk->commands.data() + 6 * row, 6);
    writer->add(RecordingTick{&world, commands, chunk->tick_hashes[row], true});
  }
  REQUIRE(writer->finish({}));
  const auto full = expanded(readerOf(bytes));
  REQUIRE_FALSE(full);
  CHECK(full.error().code == ErrorCode::kBadInput);
  CHECK(full.error().message.find("game.fbr: simulated again, it differs from tick ") == 0);
}

}  // namespace fulbito
